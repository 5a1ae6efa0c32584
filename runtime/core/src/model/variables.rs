//! Functions with the names of variables in emitted code. A variable may shadow a function, but no
//! constant, static or unit struct; which of these stand beside a model is not known when it is
//! derived, but what emitted code imports is found first.

macro_rules! names {
    ($($name:ident)*) => {$(#[allow(missing_docs, reason = "a name")] pub const fn $name() {})*};
}

names! {
    accelerations angles chain cos derivative entry form i k kinks multipliers nominal of order pivots put rates set sin solved
    state t values visitor
}
