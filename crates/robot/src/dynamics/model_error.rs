use crate::{Dynamics, DynamicsError, LinkInertia};

impl<const N: usize> Dynamics<N> {
    /// A model of this arm whose link masses and moments of inertia are off: those of link `i` times `1 + shares[i]`.
    ///
    /// For studies of controllers that know the arm only so well; lengths and centres of mass stay, and so do the links behind
    /// followers.
    ///
    /// # Errors
    ///
    /// A share below -1 or not finite: a link without a valid mass.
    pub fn with_mass_errors(&self, shares: &[f64; N]) -> Result<Self, DynamicsError> {
        let mut model = self.clone();
        for (i, (link, share)) in model.links.iter_mut().zip(shares).enumerate() {
            let factor = 1.0 + share;
            *link = LinkInertia { mass: link.mass * factor, com: link.com, inertia: link.inertia * factor };
            link.validate().map_err(|fault| DynamicsError::Link { link: i, fault })?;
        }
        Ok(model)
    }
}
