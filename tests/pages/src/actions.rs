//! What hands do to a page: real pointers and keys, places in pixels of the window.

use crate::{Browser, BrowserError};
use serde_json::{Value, json};

/// Keys without a letter, by their code points in WebDriver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// ←
    Left,
    /// →
    Right,
    /// Home
    Home,
    /// End
    End,
    /// ⇧, held with the next key.
    Shift,
    /// A letter or sign.
    Sign(char),
}

impl Key {
    const fn code(self) -> char {
        match self {
            Self::Left => '\u{e012}',
            Self::Right => '\u{e014}',
            Self::Home => '\u{e011}',
            Self::End => '\u{e010}',
            Self::Shift => '\u{e008}',
            Self::Sign(sign) => sign,
        }
    }
}

impl Browser {
    /// The middle of the first element of a selector, once it has been scrolled into sight.
    ///
    /// # Errors
    /// There is none; as every command.
    pub fn middle(&self, selector: &str) -> Result<[f64; 2], BrowserError> {
        self.within(selector, [0.5, 0.5])
    }

    /// A place within the first element of a selector, from its left upper corner in parts of its
    /// size, once it has been scrolled into sight.
    ///
    /// # Errors
    /// There is none; as every command.
    pub fn within(&self, selector: &str, [x, y]: [f64; 2]) -> Result<[f64; 2], BrowserError> {
        let place = self.script(&format!(
            "const node = document.querySelector({selector:?});
             if (!node) return null;
             node.scrollIntoView({{ block: 'nearest' }});
             const box = node.getBoundingClientRect();
             return [box.left + {x} * box.width, box.top + {y} * box.height];"
        ))?;
        let number = |i: usize| place[i].as_f64();
        let missing = || BrowserError::Page(format!("there is no {selector}"));
        number(0).zip(number(1)).map(|(x, y)| [x, y]).ok_or_else(missing)
    }

    /// Clicks the middle of the first element of a selector.
    ///
    /// # Errors
    /// There is none; as every command.
    pub fn click(&self, selector: &str) -> Result<(), BrowserError> {
        let at = self.middle(selector)?;
        self.pointer("mouse", &[moved(at), down(), up()])
    }

    /// Presses the mouse at a place and moves it, held, through others.
    ///
    /// # Errors
    /// As every command.
    pub fn drag(&self, path: &[[f64; 2]]) -> Result<(), BrowserError> {
        self.pointer("mouse", &stroke(path))
    }

    /// The same with a finger.
    ///
    /// # Errors
    /// As every command.
    pub fn swipe(&self, path: &[[f64; 2]]) -> Result<(), BrowserError> {
        self.pointer("touch", &stroke(path))
    }

    /// Two fingers, each from its first place to its second.
    ///
    /// # Errors
    /// As every command.
    pub fn pinch(&self, fingers: [[[f64; 2]; 2]; 2]) -> Result<(), BrowserError> {
        let sources: Vec<Value> =
            fingers.iter().enumerate().map(|(i, path)| source("touch", i, &stroke(path))).collect();
        self.perform(&json!(sources))
    }

    /// Turns the wheel over the middle of an element.
    ///
    /// # Errors
    /// There is none; as every command.
    pub fn wheel(&self, selector: &str, by: i32) -> Result<(), BrowserError> {
        let [x, y] = self.middle(selector)?;
        let turn = json!({ "type": "scroll", "x": x.round() as i64, "y": y.round() as i64, "deltaX": 0, "deltaY": by, "duration": 0 });
        self.perform(&json!([{ "type": "wheel", "id": "wheel", "actions": [turn] }]))
    }

    /// Presses keys together, and lets them go.
    ///
    /// # Errors
    /// As every command.
    pub fn press(&self, keys: &[Key]) -> Result<(), BrowserError> {
        let act = |kind: &str, key: &Key| json!({ "type": kind, "value": key.code().to_string() });
        let pressed = keys.iter().map(|key| act("keyDown", key));
        let released = keys.iter().rev().map(|key| act("keyUp", key));
        let actions: Vec<Value> = pressed.chain(released).collect();
        self.perform(&json!([{ "type": "key", "id": "keys", "actions": actions }]))
    }

    fn pointer(&self, kind: &str, actions: &[Value]) -> Result<(), BrowserError> {
        self.perform(&json!([source(kind, 0, actions)]))
    }

    fn perform(&self, sources: &Value) -> Result<(), BrowserError> {
        self.command("/actions", &json!({ "actions": sources }))?;
        // The page has heard of it by the end of its next frame.
        self.script("return new Promise((done) => requestAnimationFrame(() => setTimeout(done)))").map(drop)
    }
}

fn source(kind: &str, finger: usize, actions: &[Value]) -> Value {
    json!({ "type": "pointer", "id": format!("{kind}{finger}"), "parameters": { "pointerType": kind }, "actions": actions })
}

fn stroke(path: &[[f64; 2]]) -> Vec<Value> {
    let mut actions: Vec<Value> = path.iter().map(|at| moved(*at)).collect();
    actions.insert(1.min(actions.len()), down());
    actions.push(up());
    actions
}

fn moved([x, y]: [f64; 2]) -> Value {
    json!({ "type": "pointerMove", "duration": 60, "x": x.round() as i64, "y": y.round() as i64, "origin": "viewport" })
}

fn down() -> Value {
    json!({ "type": "pointerDown", "button": 0 })
}

fn up() -> Value {
    json!({ "type": "pointerUp", "button": 0 })
}
