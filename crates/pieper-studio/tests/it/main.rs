//! The studio without a browser: what a session does, and what its server lets in.

mod security;
mod session;
mod socket;
mod support;
