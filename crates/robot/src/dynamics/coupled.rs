use super::newton_euler::{LinkMotion, outward};
use crate::coupled::{Body, Placed};
use crate::{Dynamics, DynamicsError, JointKind, JointVector, LinkInertia, MassMatrix};
use nalgebra::Vector3;

/// Dynamics of arms with followers: those of the chain of all joints, projected on the joints that move on their own.
impl<const N: usize> Dynamics<N> {
    /// The links behind the arm's followers, in the order of [`crate::SerialArm::followers`] and each in the frame of its
    /// joint after the motion. Without this call they are massless.
    ///
    /// # Errors
    ///
    /// Another number of links than followers, or a link that is no rigid body; links are counted on after the `N` others.
    pub fn with_follower_links(self, links: Vec<LinkInertia>) -> Result<Self, DynamicsError> {
        let expected = self.arm.followers().len();
        if links.len() != expected {
            return Err(DynamicsError::FollowerLinks { found: links.len(), expected });
        }
        for (i, link) in links.iter().enumerate() {
            link.validate().map_err(|fault| DynamicsError::Link { link: N + i, fault })?;
        }
        Ok(Self { follower_links: links, ..self })
    }

    /// The links behind the arm's followers.
    #[must_use]
    pub fn follower_links(&self) -> &[LinkInertia] {
        &self.follower_links
    }

    /// The link behind a joint of the chain, in the base frame.
    pub(super) fn placed_link(&self, placed: &Placed) -> LinkInertia {
        let link = match placed.body {
            Body::Own(i) => self.links.get(i),
            Body::Follower(i) => self.follower_links.get(i),
        };
        link.copied().unwrap_or_default().seen_from(&placed.pose)
    }

    /// `Sᵀ τ` of the chain, see [`Dynamics::newton_euler`].
    pub(super) fn coupled_newton_euler(
        &self,
        q: &JointVector<N>,
        qd: &JointVector<N>,
        qdd: &JointVector<N>,
        gravity: &Vector3<f64>,
    ) -> JointVector<N> {
        let chain = self.arm.placed(q);
        let mut motion = LinkMotion { omega: Vector3::zeros(), alpha: Vector3::zeros(), acceleration: -gravity };
        let mut before = Vector3::zeros();
        let mut loads = Vec::with_capacity(chain.len());
        for placed in &chain {
            let rates = [qd, qdd].map(|v| placed.ratio * v[placed.coordinate]);
            motion = outward(&motion, &(placed.origin() - before), &placed.axis, placed.kind, rates);
            before = placed.origin();
            let link = self.placed_link(placed);
            let arm = link.com - before;
            let force = motion.at(&arm) * link.mass;
            let spin = link.inertia * motion.omega;
            let moment = arm.cross(&force) + link.inertia * motion.alpha + motion.omega.cross(&spin);
            loads.push((force, moment));
        }
        let mut torque = JointVector::zeros();
        let (mut f, mut n, mut after) = (Vector3::zeros(), Vector3::zeros(), Vector3::zeros());
        for (placed, (force, moment)) in chain.iter().zip(&loads).rev() {
            n += moment + (after - placed.origin()).cross(&f);
            f += force;
            after = placed.origin();
            torque[placed.coordinate] += placed.ratio
                * match placed.kind {
                    JointKind::Revolute => placed.axis.dot(&n),
                    JointKind::Prismatic => placed.axis.dot(&f),
                };
        }
        torque
    }

    /// `Sᵀ M S` as the sum of the links' `m Jᵥᵀ Jᵥ + Jᵂᵀ I Jᵂ`, the Jacobians being those of their centres of mass.
    pub(super) fn coupled_mass_matrix(&self, q: &JointVector<N>) -> MassMatrix<N> {
        let chain = self.arm.placed(q);
        let mut matrix = MassMatrix::<N>::zeros();
        for (i, placed) in chain.iter().enumerate() {
            let link = self.placed_link(placed);
            let mut linear = nalgebra::SMatrix::<f64, 3, N>::zeros();
            let mut angular = linear;
            for joint in &chain[..=i] {
                let (v, w) = match joint.kind {
                    JointKind::Revolute => (joint.axis.cross(&(link.com - joint.origin())), joint.axis),
                    JointKind::Prismatic => (joint.axis, Vector3::zeros()),
                };
                let mut column = linear.column_mut(joint.coordinate);
                column += v * joint.ratio;
                let mut column = angular.column_mut(joint.coordinate);
                column += w * joint.ratio;
            }
            matrix += linear.transpose() * linear * link.mass + angular.transpose() * link.inertia * angular;
        }
        for j in 0..N {
            matrix[(j, j)] += self.rotor(j);
        }
        // Rounding leaves the two triangles of a product apart.
        (matrix + matrix.transpose()) * 0.5
    }

    /// Mass times height of all links along gravity, kg m²/s².
    pub(super) fn coupled_potential_energy(&self, q: &JointVector<N>) -> f64 {
        let links = self.arm.placed(q).into_iter().map(|placed| self.placed_link(&placed));
        -links.map(|link| link.mass * link.com.dot(&self.gravity)).sum::<f64>()
    }
}
