use liftoff::prelude::*;

/// Ten local errors at the tolerance 1e-12 of these runs, each amplified tenfold by the slope of what is solved for.
const JUMP: f64 = 1e-10;

/// Where a motion breaks a law that no event may break: coordinates go on without a jump, and without an impulse from
/// outside no event adds energy.
pub fn breaches<M: BarSystem>(run: &Trajectory<M>) -> Vec<String> {
    let n = M::LAYOUT.coordinates.len();
    let energy = Output::parse::<M>("E").unwrap();
    let size = run.times().iter().fold(1.0, |most: f64, &t| most.max(run.value(&energy, t).abs()));
    let pushed = |t: f64| run.events().iter().any(|e| e.kind == EventKind::Impulse && e.t == t);
    let mut breaches = Vec::new();
    for pair in run.segments().windows(2).filter(|pair| pair[0].t0 < pair[0].t1) {
        let (t, before) = (pair[1].t0, pair[0].t1.next_down());
        let (earlier, later) = (run.state(before), run.state(t));
        for (i, coordinate) in M::LAYOUT.coordinates.iter().enumerate() {
            let moves = (earlier[n + i].abs() + later[n + i].abs()) * (t - before);
            if (later[i] - earlier[i]).abs() > JUMP + moves {
                breaches.push(format!("{} from {} to {} at {t}", coordinate.name, earlier[i], later[i]));
            }
        }
        let [earlier, later] = [before, t].map(|t| run.value(&energy, t));
        if later > earlier + JUMP * size && !pushed(t) {
            breaches.push(format!("E from {earlier} to {later} at {t}"));
        }
    }
    breaches
}
