//! Recordings of the core: inputs as a text for the replaying programs, outputs as the text that they must print.

pub(crate) mod cases;
pub(crate) mod paths;

/// A recording that grows.
#[derive(Default)]
pub(crate) struct Recording {
    /// Input of a replaying program.
    pub(crate) input: String,
    /// Text that the program must print.
    pub(crate) output: String,
}

fn bits(text: &mut String, numbers: &[f64]) {
    for x in numbers {
        text.push_str(&format!("{:016x} ", x.to_bits()));
    }
}

impl Recording {
    pub(crate) fn begin(&mut self, case: &str, counts: &[u32]) {
        self.input.push_str(case);
        for count in counts {
            self.input.push_str(&format!(" {count}"));
        }
        self.input.push('\n');
    }

    pub(crate) fn read(&mut self, numbers: &[f64]) {
        bits(&mut self.input, numbers);
        self.input.push('\n');
    }

    pub(crate) fn print(&mut self, numbers: &[f64]) {
        bits(&mut self.output, numbers);
    }

    pub(crate) fn end_line(&mut self, words: &[u32]) {
        let words: Vec<String> = words.iter().map(u32::to_string).collect();
        self.output.push_str(&words.join(" "));
        self.output.push('\n');
    }
}

/// Numbers that look random and are the same everywhere: Knuth's linear congruential generator.
pub(crate) struct Numbers(pub(crate) u64);

impl Numbers {
    /// Uniform in [-1, 1).
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    pub(crate) fn vector<const N: usize>(&mut self, size: f64) -> [f64; N] {
        std::array::from_fn(|_| size * self.next())
    }
}
