//! Polynomials in Bernstein form whose coefficients are known to within a radius.
//!
//! On `[0, 1]` a polynomial lies between its least and its greatest Bernstein coefficient, which is how a statement about every
//! point of a cell becomes one about a few numbers. The numbers are rounded: a [`Polynomial`] stands for every polynomial whose
//! coefficients differ from the stored ones by at most `radius`. Each operation enlarges the radius by a bound of its own rounding.
//!
//! Source: Farouki, "The Bernstein polynomial basis: a centennial retrospective", Computer Aided Geometric Design 29 (2012).

/// Largest degree of the derivative of a path in a cell: paths of degree 5 have degree 10 in the parameter at a rest end.
pub(crate) const MAX_DEGREE: usize = 9;
/// Coefficients of the largest degree.
pub(crate) const COEFFICIENTS: usize = MAX_DEGREE + 1;
/// Coefficients of the product of two derivatives and a quadratic, the largest product that is formed.
pub(crate) const PRODUCT: usize = 2 * MAX_DEGREE + 3;

const BINOMIALS: [[f64; PRODUCT]; PRODUCT] = {
    let mut table = [[0.0; PRODUCT]; PRODUCT];
    let mut n = 0;
    while n < PRODUCT {
        table[n][0] = 1.0;
        let mut k = 1;
        while k <= n {
            table[n][k] = table[n - 1][k - 1] + table[n - 1][k];
            k += 1;
        }
        n += 1;
    }
    table
};

/// `BY_QUADRATIC[p][i][e]`: share of coefficient `i` of degree `p` times coefficient `e` of degree 2 in coefficient `i + e` of the
/// product. At most 1, and the shares of one coefficient of the product add to 1.
pub(crate) const BY_QUADRATIC: [[[f64; 3]; PRODUCT - 2]; PRODUCT - 2] = {
    let mut table = [[[0.0; 3]; PRODUCT - 2]; PRODUCT - 2];
    let mut p = 0;
    while p < PRODUCT - 2 {
        let mut i = 0;
        while i <= p {
            let mut e = 0;
            while e < 3 {
                table[p][i][e] = BINOMIALS[p][i] * BINOMIALS[2][e] / BINOMIALS[p + 2][i + e];
                e += 1;
            }
            i += 1;
        }
        p += 1;
    }
    table
};

/// The number of ways to choose `k` of `n`.
pub(crate) fn binomial(n: usize, k: usize) -> f64 {
    BINOMIALS[n][k]
}

/// A polynomial of degree at most [`MAX_DEGREE`] on `[0, 1]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Polynomial {
    degree: usize,
    coefficients: [f64; COEFFICIENTS],
    /// Bound of what each stored coefficient is off.
    pub(crate) radius: f64,
}

impl Polynomial {
    /// The polynomial of exactly these Bernstein coefficients, at least one and at most [`COEFFICIENTS`].
    pub(crate) fn new(values: &[f64]) -> Self {
        let mut coefficients = [0.0; COEFFICIENTS];
        let count = values.len().clamp(1, COEFFICIENTS);
        for (to, from) in coefficients.iter_mut().zip(values) {
            *to = *from;
        }
        Self { degree: count - 1, coefficients, radius: 0.0 }
    }

    /// The polynomial from powers of the parameter: `sum_m powers[m] t^m`, rounded.
    pub(crate) fn of_powers(powers: &[f64]) -> Self {
        let mut result = Self::new(powers);
        let degree = result.degree;
        for i in 0..=degree {
            result.coefficients[i] = (0..=i).map(|m| powers[m] * BINOMIALS[i][m] / BINOMIALS[degree][m]).sum();
        }
        result
    }

    /// The degree.
    pub(crate) fn degree(&self) -> usize {
        self.degree
    }

    /// The stored Bernstein coefficients.
    pub(crate) fn coefficients(&self) -> &[f64] {
        &self.coefficients[..=self.degree]
    }

    /// The same, to be changed.
    pub(crate) fn coefficients_mut(&mut self) -> &mut [f64] {
        &mut self.coefficients[..=self.degree]
    }

    /// Value at `t` by plain arithmetic, for guides only.
    pub(crate) fn at(&self, t: f64) -> f64 {
        let (n, u) = (self.degree, 1.0 - t);
        let (mut power, mut sum) = (1.0, self.coefficients[0]);
        for i in 1..=n {
            power *= t;
            sum = sum * u + power * BINOMIALS[n][i] * self.coefficients[i];
        }
        sum
    }

    /// The largest absolute coefficient, without the radius.
    pub(crate) fn largest(&self) -> f64 {
        self.coefficients().iter().fold(0.0, |m: f64, c| m.max(c.abs()))
    }

    /// No value on `[0, 1]` is below the first number or above the second.
    pub(crate) fn range(&self) -> (f64, f64) {
        let start = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) = self.coefficients().iter().fold(start, |(l, h), c| (l.min(*c), h.max(*c)));
        ((low - self.radius).next_down(), (high + self.radius).next_up())
    }

    /// No absolute value on `[0, 1]` is below the first number or above the second.
    pub(crate) fn absolute_range(&self) -> (f64, f64) {
        let (low, high) = self.range();
        let least = if low > 0.0 { low } else { (-high).max(0.0) };
        (least, high.max(-low))
    }

    /// Both halves, each on `[0, 1]` again, by de Casteljau's algorithm. Every coefficient of a half is an average of coefficients, so
    /// the radius is kept; each of the `degree` averagings rounds by at most half an epsilon of the largest coefficient.
    pub(crate) fn halves(&self) -> (Self, Self) {
        let n = self.degree;
        let (mut left, mut right) = (*self, *self);
        let c = &mut right.coefficients;
        for level in 1..=n {
            for i in 0..=n - level {
                c[i] = 0.5 * (c[i] + c[i + 1]);
            }
            left.coefficients[level] = c[0];
        }
        let radius = grown(self.radius, n as f64 * self.largest());
        (left.radius, right.radius) = (radius, radius);
        (left, right)
    }
}

/// A radius that also covers roundings of one epsilon of `size` in all.
pub(crate) fn grown(radius: f64, size: f64) -> f64 {
    // Two roundings here, each below an epsilon of the sum.
    (radius + f64::EPSILON * size) * (1.0 + 4.0 * f64::EPSILON) + f64::MIN_POSITIVE
}

/// Bernstein coefficients of the square, into `out`; each is off by at most `32 epsilon largest²` and what the radius does.
pub(crate) fn square(of: &Polynomial, out: &mut [f64; PRODUCT]) {
    product(of.coefficients(), of.coefficients(), out);
}

/// Bernstein coefficients of a product, into the first `p + q + 1` of `out`. A coefficient is a mean of at most ten products, each of
/// them rounded five times: off by less than `32 epsilon` times the product of the largest coefficients.
pub(crate) fn product(f: &[f64], g: &[f64], out: &mut [f64; PRODUCT]) {
    let (p, q) = (f.len() - 1, g.len() - 1);
    out[..=p + q].fill(0.0);
    for (i, a) in f.iter().enumerate() {
        let a = a * BINOMIALS[p][i];
        for (j, b) in g.iter().enumerate() {
            out[i + j] += a * b * BINOMIALS[q][j];
        }
    }
    for (k, value) in out[..=p + q].iter_mut().enumerate() {
        *value /= BINOMIALS[p + q][k];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_and_bernstein_coefficients_give_the_same_values() {
        let powers = [0.3, -1.0, 2.0, 0.5, -0.25];
        let polynomial = Polynomial::of_powers(&powers);
        for k in 0..=10 {
            let t = f64::from(k) / 10.0;
            let plain: f64 = powers.iter().rev().fold(0.0, |sum, c| sum * t + c);
            assert!((polynomial.at(t) - plain).abs() < 1e-14);
        }
    }

    #[test]
    fn halves_are_the_polynomial_on_half_the_interval_and_ranges_contain_it() {
        let whole = Polynomial::new(&[1.0, -3.0, 2.5, 0.1, -7.0, 3.0]);
        let (left, right) = whole.halves();
        for k in 0..=10 {
            let t = f64::from(k) / 10.0;
            assert!((left.at(t) - whole.at(0.5 * t)).abs() < 1e-13);
            assert!((right.at(t) - whole.at(0.5 + 0.5 * t)).abs() < 1e-13);
            let (low, high) = left.range();
            assert!(low <= left.at(t) && left.at(t) <= high);
        }
        assert!(left.radius > 0.0 && left.radius < 1e-14);
    }

    #[test]
    fn products_multiply_values() {
        let (f, g) = ([1.0, -2.0, 0.5], [0.2, 4.0, -1.0, 3.0]);
        let mut out = [0.0; PRODUCT];
        product(&f, &g, &mut out);
        let (f, g, h) = (Polynomial::new(&f), Polynomial::new(&g), Polynomial::new(&out[..6]));
        for t in [0.0, 0.25, 0.6, 1.0] {
            assert!((f.at(t) * g.at(t) - h.at(t)).abs() < 1e-13);
        }
    }
}
