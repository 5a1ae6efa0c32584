//! Rows of the two-sided constraints.

use nalgebra::Vector2;

use super::Row;
use crate::oracle::{Assembly, Drive, Guide, Place, Slider, State};

const AXES: [Vector2<f64>; 2] = [Vector2::new(1.0, 0.0), Vector2::new(0.0, 1.0)];

impl Assembly {
    /// Two rows a hinge, two a pin, two a carried particle, one a tie, a slider, a drive, in this
    /// order.
    pub fn joint_rows(&self, state: &State) -> Vec<Row> {
        let together = |a: Place, b: Place| {
            AXES.map(|d| self.projection(state, a, d).minus(self.projection(state, b, d)))
        };
        let hinges = self.hinges.iter().flat_map(|h| together(h.first.into(), h.second.into()));
        let pins = self.pins.iter().flat_map(|pin| together(pin.at.into(), Place::Ground(pin.ground)));
        let carriers = self.particles.iter().enumerate();
        let carried = carriers.filter_map(|(index, particle)| Some((index, particle.carrier?)));
        let particles = carried.flat_map(|(index, at)| together(at.into(), Place::Particle(index)));
        let ties = self.ties.iter().map(|tie| {
            let sum: f64 = tie.terms.iter().map(|&(body, c)| c * state.angle(body)).sum();
            Row::of_angles(&tie.terms, sum - tie.value)
        });
        let sliders = self.sliders.iter().map(|slider| self.slider_row(state, slider));
        let drives = self.drives.iter().map(|drive| self.drive_row(state, drive));
        hinges.chain(pins).chain(particles).chain(ties).chain(sliders).chain(drives).collect()
    }

    fn slider_row(&self, state: &State, slider: &Slider) -> Row {
        match slider.guide {
            Guide::Line { through, normal } => {
                let mut row = self.projection(state, slider.point, normal);
                row.value -= normal.dot(&through);
                row
            }
            Guide::Axis(body) => self.offset(state, slider.point, body),
        }
    }

    fn drive_row(&self, state: &State, drive: &Drive) -> Row {
        let [value, rate, second] = drive.value.jet(self, state);
        let mut row = self.reading(state, &drive.reading);
        row.value -= value;
        row.prescribed_gap_rate -= rate;
        row.bias -= second;
        row
    }
}
