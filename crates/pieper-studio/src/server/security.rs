//! Who may talk to the studio: this computer's own pages, with the token of this start.

use axum::http::{HeaderMap, HeaderValue, Method, StatusCode, header};

/// The token of this start, and the names under which the studio is served.
pub(super) struct Keys {
    token: String,
    port: u16,
}

/// A refusal: its status and one sentence.
pub(super) type Refusal = (StatusCode, &'static str);

impl Keys {
    pub(super) fn new(port: u16) -> Result<Self, getrandom::Error> {
        Ok(Self {
            token: random_hex()?,
            port,
        })
    }

    pub(super) fn url(&self) -> String {
        format!("http://127.0.0.1:{}/#token={}", self.port, self.token)
    }

    /// The cookie that a page gets for the token.
    pub(super) fn cookie(&self) -> String {
        format!(
            "{}={}; HttpOnly; SameSite=Strict; Path=/",
            self.cookie_name(),
            self.token
        )
    }

    fn cookie_name(&self) -> String {
        format!("pieper_{}", self.port)
    }

    fn is_own(&self, host: &str) -> bool {
        let name = host.strip_suffix(&format!(":{}", self.port));
        matches!(name, Some("127.0.0.1" | "localhost"))
    }

    /// Whether a request comes from this computer's own pages: by `Host` against rebinding, by `Origin` against other pages.
    pub(super) fn check_place(
        &self,
        method: &Method,
        headers: &HeaderMap,
        socket: bool,
    ) -> Result<(), Refusal> {
        const HOST: Refusal = (
            StatusCode::FORBIDDEN,
            "this studio answers only to 127.0.0.1 and localhost with its own port",
        );
        const ORIGIN: Refusal = (
            StatusCode::FORBIDDEN,
            "another page may not talk to this studio",
        );
        let mut hosts = headers.get_all(header::HOST).iter();
        let host = hosts.next().and_then(|host| host.to_str().ok());
        if !host.is_some_and(|host| self.is_own(host)) || hosts.next().is_some() {
            return Err(HOST);
        }
        let mut origins = headers.get_all(header::ORIGIN).iter();
        let Some(origin) = origins.next() else {
            // Browsers always send one here; a program does not, and shows its token instead of a cookie.
            let needed = socket || method == Method::POST;
            return if needed && headers.contains_key(header::COOKIE) {
                Err(ORIGIN)
            } else {
                Ok(())
            };
        };
        let own = origin
            .to_str()
            .ok()
            .and_then(|origin| origin.strip_prefix("http://"));
        if own.is_some_and(|host| self.is_own(host)) && origins.next().is_none() {
            Ok(())
        } else {
            Err(ORIGIN)
        }
    }

    /// Whether a request carries the token, as a cookie or as a bearer.
    pub(super) fn check_token(&self, headers: &HeaderMap) -> Result<(), Refusal> {
        let bearer = headers
            .get(header::AUTHORIZATION)
            .and_then(|value| value.to_str().ok())
            .and_then(|value| value.strip_prefix("Bearer "));
        let wanted = self.cookie_name();
        let cookies = headers
            .get_all(header::COOKIE)
            .iter()
            .filter_map(|value| value.to_str().ok());
        let cookie = cookies.flat_map(|line| line.split(';')).find_map(|pair| {
            let (name, value) = pair.trim().split_once('=')?;
            (name == wanted).then_some(value)
        });
        match [bearer, cookie]
            .into_iter()
            .flatten()
            .any(|given| self.is_token(given))
        {
            true => Ok(()),
            false => Err((
                StatusCode::UNAUTHORIZED,
                "the token of this start was expected: open the address that the program printed",
            )),
        }
    }

    /// Compares in a time that does not depend on where a wrong one differs.
    pub(super) fn is_token(&self, given: &str) -> bool {
        let (own, given) = (self.token.as_bytes(), given.as_bytes());
        own.len() == given.len() && own.iter().zip(given).fold(0, |all, (a, b)| all | (a ^ b)) == 0
    }
}

/// 128 random bits.
pub(super) fn random_hex() -> Result<String, getrandom::Error> {
    let mut bytes = [0_u8; 16];
    getrandom::fill(&mut bytes)?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}

/// The headers of every answer; `nonce` allows the styles that the editor makes.
pub(super) fn harden(headers: &mut HeaderMap, nonce: Option<&str>) {
    let style = nonce.map_or(String::new(), |nonce| format!(" 'nonce-{nonce}'"));
    let policy = format!(
        "default-src 'none'; script-src 'self'; style-src 'self'{style}; img-src 'self' data: blob:; connect-src 'self'; \
         font-src 'self'; worker-src 'self' blob:; frame-ancestors 'none'; base-uri 'none'; form-action 'none'"
    );
    if let Ok(policy) = HeaderValue::from_str(&policy) {
        headers.insert(header::CONTENT_SECURITY_POLICY, policy);
    }
    for (name, value) in [
        ("x-content-type-options", "nosniff"),
        ("referrer-policy", "no-referrer"),
        ("cross-origin-opener-policy", "same-origin"),
        ("cross-origin-resource-policy", "same-origin"),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
}
