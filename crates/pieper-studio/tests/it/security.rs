//! Who is let in: the table of hosts, origins and tokens.

use crate::support::{serve, session};
use pieper_studio::{Options, Studio};

#[test]
fn hosts_origins_and_tokens() {
    let studio = serve("ar3");
    let port = studio.port;
    let own = format!("Host: 127.0.0.1:{port}");
    let bearer = format!("Authorization: Bearer {}", studio.token);
    let cookie = format!("Cookie: pieper_{port}={}", studio.token);
    let origin = format!("Origin: http://127.0.0.1:{port}");
    let local = (
        format!("Host: localhost:{port}"),
        format!("Origin: http://localhost:{port}"),
    );
    let (state, command) = ("GET /api/state", "POST /api/command");
    let undo = r#"{"do":"seek","t":0}"#;
    let text = str::to_owned;
    let table: Vec<(&str, Vec<String>, &str, u16)> = vec![
        ("GET /", vec![own.clone()], "", 200),
        ("GET /", vec![local.0.clone()], "", 200),
        ("GET /", vec![], "", 403),
        ("GET /", vec![text("Host: evil.example")], "", 403),
        ("GET /", vec![format!("Host: evil.example:{port}")], "", 403),
        (
            "GET /",
            vec![format!("Host: 127.0.0.1.evil.example:{port}")],
            "",
            403,
        ),
        ("GET /", vec![text("Host: 127.0.0.1:1")], "", 403),
        ("GET /", vec![text("Host: 127.0.0.1")], "", 403),
        (
            "GET /",
            vec![own.clone(), text("Origin: http://evil.example")],
            "",
            403,
        ),
        (state, vec![own.clone()], "", 401),
        (
            state,
            vec![own.clone(), text("Authorization: Bearer 00")],
            "",
            401,
        ),
        (
            state,
            vec![own.clone(), text("Authorization: Bearer ")],
            "",
            401,
        ),
        (
            state,
            vec![own.clone(), format!("Cookie: pieper_1={}", studio.token)],
            "",
            401,
        ),
        (state, vec![own.clone(), bearer.clone()], "", 200),
        (state, vec![own.clone(), cookie.clone()], "", 200),
        (
            state,
            vec![text("Host: evil.example"), bearer.clone()],
            "",
            403,
        ),
        (
            state,
            vec![
                own.clone(),
                cookie.clone(),
                text("Origin: http://evil.example"),
            ],
            "",
            403,
        ),
        (
            state,
            vec![own.clone(), cookie.clone(), text("Origin: null")],
            "",
            403,
        ),
        (
            state,
            vec![
                own.clone(),
                cookie.clone(),
                format!("Origin: https://127.0.0.1:{port}"),
            ],
            "",
            403,
        ),
        (command, vec![own.clone(), bearer.clone()], undo, 200),
        (
            command,
            vec![own.clone(), cookie.clone(), origin.clone()],
            undo,
            200,
        ),
        (
            command,
            vec![local.0.clone(), cookie.clone(), local.1.clone()],
            undo,
            200,
        ),
        (command, vec![own.clone(), cookie.clone()], undo, 403),
        (command, vec![own.clone(), origin.clone()], undo, 401),
        (command, vec![own.clone(), bearer.clone()], "nonsense", 422),
        (
            command,
            vec![own.clone(), bearer.clone()],
            r#"{"do":"fly"}"#,
            422,
        ),
        (
            "POST /api/session",
            vec![own.clone(), origin.clone()],
            r#"{"token":"00"}"#,
            401,
        ),
        (
            "POST /api/session",
            vec![own.clone(), text("Origin: http://evil.example")],
            "{}",
            403,
        ),
        (
            "GET /api/nothing",
            vec![own.clone(), bearer.clone()],
            "",
            404,
        ),
        ("GET /assets/../../Cargo.toml", vec![own.clone()], "", 404),
        ("GET /assets/%2e%2e/index.html", vec![own.clone()], "", 404),
        ("GET /mesh/00", vec![own.clone(), bearer.clone()], "", 404),
    ];
    for (first, headers, body, status) in table {
        assert_eq!(
            studio.status(first, &headers, body),
            status,
            "{first} {headers:?} {body}"
        );
    }
}

#[test]
fn windows_need_an_origin_or_a_bearer() {
    let studio = serve("ar3");
    let port = studio.port;
    let upgrade = |more: &[String]| {
        let mut headers = vec![
            format!("Host: 127.0.0.1:{port}"),
            "Upgrade: websocket".to_owned(),
            "Sec-WebSocket-Version: 13".to_owned(),
            "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==".to_owned(),
        ];
        headers.extend(more.iter().cloned());
        let request = headers.join("\n");
        let answer = studio.raw(&format!(
            "GET /ws HTTP/1.1\nConnection: Upgrade\n{request}\n\n"
        ));
        answer.split(' ').nth(1).unwrap_or_default().to_owned()
    };
    let cookie = format!("Cookie: pieper_{port}={}", studio.token);
    let origin = format!("Origin: http://127.0.0.1:{port}");
    let bearer = format!("Authorization: Bearer {}", studio.token);
    assert_eq!(upgrade(&[bearer]), "101");
    assert_eq!(upgrade(&[cookie.clone(), origin.clone()]), "101");
    assert_eq!(upgrade(&[origin]), "401");
    // The refusals close nothing by themselves: Connection: Upgrade keeps them open, so their heads are read with a timeout.
    assert_eq!(
        upgrade(&[
            cookie.clone(),
            "Origin: http://evil.example".to_owned(),
            "Connection: close".to_owned()
        ]),
        "403"
    );
    assert_eq!(upgrade(&[cookie, "Connection: close".to_owned()]), "403");
}

#[test]
fn every_answer_is_hardened() {
    let studio = serve("ar3");
    for path in ["/", "/api/state", "/nothing", "/assets/none.js"] {
        let answer = studio.raw(&format!(
            "GET {path} HTTP/1.1\nHost: 127.0.0.1:{}\nConnection: close\n\n",
            studio.port
        ));
        let head = answer
            .split("\r\n\r\n")
            .next()
            .unwrap()
            .to_ascii_lowercase();
        for header in [
            "content-security-policy: default-src 'none'",
            "x-content-type-options: nosniff",
            "referrer-policy: no-referrer",
            "cross-origin-opener-policy: same-origin",
            "cross-origin-resource-policy: same-origin",
        ] {
            assert!(head.contains(header), "{path}: {header}: {head}");
        }
    }
    let page = |_: i32| {
        studio.raw(&format!(
            "GET / HTTP/1.1\nHost: 127.0.0.1:{}\nConnection: close\n\n",
            studio.port
        ))
    };
    let nonce = |page: String| {
        page.split("'nonce-")
            .nth(1)
            .and_then(|rest| rest.split('\'').next())
            .map(str::to_owned)
            .unwrap()
    };
    let (first, second) = (page(1), page(2));
    assert!(
        !first.contains(&studio.token),
        "the token is not in the page"
    );
    assert!(
        first.matches(&nonce(first.clone())).count() == 2,
        "in the policy and in the page"
    );
    assert_ne!(nonce(first), nonce(second));
}

#[test]
fn a_port_in_use_is_said_with_the_remedy() {
    let taken = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port();
    let error = Studio::bind(
        session("ar3"),
        &Options {
            port,
            ..Options::default()
        },
    )
    .err()
    .unwrap();
    assert!(
        error.contains(&port.to_string()) && error.contains("--port"),
        "{error}"
    );
}
