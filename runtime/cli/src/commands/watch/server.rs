//! The page on this computer alone.

use crate::CommandError;
use liftoff_studio::html::{escaped, page};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use tiny_http::{Header, Response};

/// Asks for the number of what is shown, and for the page where it is another.
const FOLLOW: &str = include_str!("follow.js");

/// How mistakes lie over the page.
const STYLE: &str = "position:sticky;top:0;z-index:9;margin:0;padding:1em;overflow:auto;max-height:60vh;\
                     background:#fff4f4;color:#900;border-bottom:2px solid #900;font:14px/1.4 monospace";

/// The last page that could be made, what is wrong with the text now, and how often that has changed.
#[derive(Default)]
pub(super) struct Shown(Mutex<State>);

#[derive(Default)]
struct State {
    number: u64,
    page: Option<String>,
    mistakes: Option<String>,
}

impl Shown {
    /// Shows a page.
    pub fn page(&self, page: String) {
        let mut state = self.state();
        (state.page, state.mistakes) = (Some(page), None);
        state.number += 1;
    }

    /// Shows mistakes over the last page.
    pub fn mistakes(&self, text: &str) {
        let mut state = self.state();
        state.mistakes = Some(text.to_owned());
        state.number += 1;
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn number(&self) -> String {
        self.state().number.to_string()
    }

    fn html(&self) -> String {
        let state = self.state();
        let over = state.mistakes.as_ref().map_or_else(String::new, |text| {
            format!("<pre id=mistakes role=alert style=\"{STYLE}\">{}</pre>\n", escaped(text))
        });
        let follow = format!(
            "<script>\n\"use strict\";\n{}</script>\n",
            FOLLOW.replace("NUMBER", &state.number.to_string())
        );
        let made = state.page.clone().unwrap_or_else(|| page("liftoff watch", "", ""));
        match made.split_once("<body>\n") {
            Some((head, body)) => format!("{head}<body>\n{over}{follow}{body}"),
            None => made,
        }
    }
}

/// A server on a thread of its own, as long as the program runs.
pub(super) struct Server {
    address: String,
}

impl Server {
    /// Begins to serve what is shown; 0 stands for any port that is free.
    pub fn begin(port: u16, shown: Arc<Shown>) -> Result<Self, CommandError> {
        let failed = |why: &dyn core::fmt::Display| {
            CommandError::Failed(format!("cannot listen on port {port}: {why}"))
        };
        let http = tiny_http::Server::http(("127.0.0.1", port)).map_err(|error| failed(&error))?;
        let at = http.server_addr().to_ip().ok_or_else(|| failed(&"no address"))?;
        let address = format!("http://{at}/");
        let hosts = [at.to_string(), format!("localhost:{}", at.port())];
        thread::spawn(move || http.incoming_requests().for_each(|request| answer(request, &hosts, &shown)));
        Ok(Self { address })
    }

    /// Where the page is.
    pub fn address(&self) -> &str {
        &self.address
    }
}

/// Answers those who ask for this computer: a page of another name that leads here learns nothing.
fn answer(request: tiny_http::Request, hosts: &[String], shown: &Shown) {
    let asked = request.headers().iter().find(|header| header.field.equiv("Host"));
    let own = asked.is_some_and(|asked| hosts.iter().any(|host| asked.value == host.as_str()));
    // The panels of some editors add a query.
    let path = request.url().split('?').next().unwrap_or_default();
    let (kind, text) = match (own, path) {
        (true, "/") => ("text/html; charset=utf-8", shown.html()),
        (true, "/number") => ("text/plain", shown.number()),
        _ => {
            // Who has gone away needs no answer.
            let _ = request.respond(Response::empty(404));
            return;
        }
    };
    let header = |name: &str, value: &str| Header::from_bytes(name, value).ok();
    let mut response = Response::from_string(text);
    for header in [header("Content-Type", kind), header("Cache-Control", "no-store")].into_iter().flatten() {
        response.add_header(header);
    }
    let _ = request.respond(response);
}
