//! What the tree leaves open: closed loops and further pins, as rows.

use proc_macro2::Span;

use super::guides::proportional;
use super::positions::{AXES, Closure, Component, Layout};
use super::{Joint, JointKind};
use crate::algebra::{Series, Symbol};

impl Layout<'_> {
    /// The rows of closed loops and further pins of a component.
    pub(super) fn close(&mut self, component: &Component, pin: Option<usize>) -> syn::Result<()> {
        for Closure { point, body, gap } in &component.closures {
            let name = format!("hinge at {}", self.system.points[*point].name);
            let kind = |axis| JointKind::Hinge { point: *point, body: *body, axis };
            self.constrain(&name, self.system.points[*point].span, gap, kind)?;
        }
        let further: Vec<_> = (0..self.system.pins.len())
            .filter(|i| Some(*i) != pin && component.members.contains(&self.system.pins[*i].point))
            .collect();
        for i in further {
            let pin = &self.system.pins[i];
            let Some(position) = &self.points[pin.point] else { continue };
            let gap = core::array::from_fn(|axis| &position[axis] - &pin.at[axis]);
            let name = format!("pin {}", self.system.points[pin.point].name);
            self.constrain(&name, pin.span, &gap, |axis| JointKind::Pin { point: pin.point, axis })?;
        }
        Ok(())
    }

    fn constrain(
        &mut self,
        name: &str,
        span: Span,
        gap: &[Series; 2],
        kind: impl Fn(usize) -> JointKind,
    ) -> syn::Result<()> {
        for (axis, equation) in gap.iter().enumerate() {
            let moves = equation.symbols().iter().any(|s| matches!(s, Symbol::Coordinate { .. }));
            let repeated = self.joints.iter().any(|j| proportional(&j.equation, equation));
            if moves && !(repeated && self.system.mirror.is_some()) {
                let name = format!("{name} ({})", AXES[axis]);
                self.joints.push(Joint { name, equation: equation.clone(), kind: kind(axis), span });
            } else if !moves && !equation.is_zero() {
                return Err(syn::Error::new(
                    span,
                    format!("{name} cannot close: nothing that moves could bring it there"),
                ));
            }
        }
        Ok(())
    }
}
