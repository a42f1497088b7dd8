//! Scripts that work, and scripts that try to take the studio with them.

use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::socket::{Window, is_pose, open, say, until};
use crate::support::serve;

/// A window on a studio that has found its Python; `None` where there is none (the test command installs one in CI).
async fn ready(id: &str) -> Option<Window> {
    let studio = serve(id);
    let mut window = open(&studio).await;
    let script = until(&mut window, |value| {
        value["section"] == "script" && !value["value"]["python"].is_null()
    })
    .await;
    (script["value"]["python"]["found"] == true).then_some(window)
}

/// Runs a script to its end: the last section, and what it printed.
async fn run(window: &mut Window, text: &str) -> (Value, String) {
    begin(window, text).await;
    end(window).await
}

/// Starts a script. The answer says that it runs: what lasts shorter than a picture is not told of otherwise.
async fn begin(window: &mut Window, text: &str) {
    say(window, json!({"id": 1, "do": "script_run", "text": text})).await;
    until(window, |value| value["ack"] == 1).await;
}

/// Waits for the end of a script that runs.
async fn end(window: &mut Window) -> (Value, String) {
    let mut printed = String::new();
    let section = until(window, |value| {
        if value["event"] == "console" {
            printed += value["text"].as_str().unwrap();
        }
        value["section"] == "script" && value["value"]["running"] == false
    })
    .await;
    (section["value"].clone(), printed)
}

/// The studio still answers.
async fn alive(window: &mut Window) {
    say(
        window,
        json!({"id": 99, "do": "joint", "joint": 0, "value": 0.125}),
    )
    .await;
    until(window, |value| is_pose(value, 0, 0.125)).await;
}

#[tokio::test]
async fn the_papers_example_runs_unchanged() {
    let Some(mut window) = ready("ar3").await else {
        return;
    };
    say(&mut window, json!({"id": 1, "do": "script_examples"})).await;
    let examples = until(&mut window, |value| value["ack"] == 1).await;
    let text = examples["value"][0]["text"]
        .as_str()
        .unwrap()
        .replace("range(70)", "range(8)");
    say(&mut window, json!({"do": "script_run", "text": text})).await;
    // Joint 2 runs two degrees ahead of joint 1; all of it is one step of undo.
    until(&mut window, |value| {
        is_pose(value, 0, 7_f64.to_radians())
            && is_pose(value, 1, 9_f64.to_radians())
            && is_pose(value, 3, 7_f64.to_radians())
    })
    .await;
    until(&mut window, |value| {
        value["section"] == "script" && value["value"]["running"] == false
    })
    .await;
    say(&mut window, json!({"do": "undo"})).await;
    until(&mut window, |value| {
        is_pose(value, 0, 0.0) && is_pose(value, 1, 0.0)
    })
    .await;
}

#[tokio::test]
async fn mathmodel_reads_and_moves() {
    let Some(mut window) = ready("irb120").await else {
        return;
    };
    let text = "import mathmodel as m\nm.joints([10, 20, 5, 30, 40, 50])\nx = m.tool()\nassert abs(m.joint(2) - 20) < 1e-9\nm.joint(1, 0)\nm.move(*x)\n\
        assert abs(m.joint(1) - 10) < 1e-6, m.joint(1)\nassert len(m.solutions()) == 8\nassert abs(m.matrix()[0][3] * 1000 - x[0]) < 1e-6\n\
        m.keyframe(1.5)\nassert len(m.limits()) == 6 and m.time() > 0\nprint('well')\n";
    let (section, printed) = run(&mut window, text).await;
    assert!(
        section["error"].is_null() && printed == "well\n",
        "{section} {printed}"
    );
}

#[tokio::test]
async fn errors_mark_their_line() {
    let Some(mut window) = ready("ar3").await else {
        return;
    };
    for (text, line, words) in [
        ("x = 1\ny = z\n", 2, "NameError"),
        ("def f(:\n", 1, "SyntaxError"),
        (
            "import mathmodel\nmathmodel.chain9(1)\n",
            2,
            "joints 1 to 6",
        ),
        (
            "import mathmodel\n\nmathmodel.move(9000, 0, 0)\n",
            3,
            "misses it by",
        ),
        (
            "import mathmodel\nmathmodel.chain1(float('nan'))\n",
            2,
            "finite",
        ),
        ("import mathmodel\nmathmodel.pause(-1)\n", 2, "pause"),
    ] {
        let (section, _) = run(&mut window, text).await;
        assert_eq!(section["error"]["line"], line, "{text}: {section}");
        assert!(
            section["error"]["text"].as_str().unwrap().contains(words),
            "{section}"
        );
    }
    let (section, _) = run(&mut window, "def checkScript():\n    return False\n").await;
    assert!(
        section["error"]["text"]
            .as_str()
            .unwrap()
            .contains("checkScript"),
        "{section}"
    );
}

#[tokio::test]
async fn stop_always_works() {
    let Some(mut window) = ready("ar3").await else {
        return;
    };
    let ignore = "import signal\nsignal.signal(signal.SIGINT, signal.SIG_IGN)\nprint('on')\nwhile True: pass\n";
    let fork =
        "import os\nfor _ in range(3): os.fork()\nprint('on', flush=True)\nwhile True: pass\n";
    let catch = "print('on')\nwhile True:\n    try:\n        while True: pass\n    except BaseException: pass\n";
    for text in [
        "print('on')\nwhile True: pass\n",
        "import mathmodel\nprint('on')\nmathmodel.pause(60000)\n",
        ignore,
        fork,
        catch,
    ] {
        say(&mut window, json!({"do": "script_run", "text": text})).await;
        until(&mut window, |value| value["event"] == "console").await;
        let start = Instant::now();
        say(&mut window, json!({"do": "script_stop"})).await;
        until(&mut window, |value| {
            value["section"] == "script" && value["value"]["running"] == false
        })
        .await;
        assert!(
            start.elapsed() < Duration::from_millis(2500),
            "{text}: {:?}",
            start.elapsed()
        );
    }
    alive(&mut window).await;
}

/// Stopped while Python starts, while modules are loaded, where exceptions are dropped, twice: it ends, and says nothing.
#[tokio::test]
async fn stop_is_silent_whenever_it_comes() {
    let Some(mut window) = ready("ar3").await else {
        return;
    };
    let import = "import sys\nwhile True:\n    for name in ['json', 'json.decoder', 'ctypes', 'wave']: sys.modules.pop(name, None)\n    import json, ctypes, wave\n";
    let destructor = "class Held:\n    def __del__(self):\n        for _ in range(1000): pass\nwhile True: Held()\n";
    for (text, count) in [
        ("while True: pass\n", 40),
        (import, 40),
        (destructor, 10),
        ("import time\ntime.sleep(60)", 5),
    ] {
        for k in 0..count {
            begin(&mut window, text).await;
            tokio::time::sleep(Duration::from_millis(4 * k)).await;
            say(&mut window, json!({"do": "script_stop"})).await;
            say(&mut window, json!({"do": "script_stop"})).await;
            let (section, printed) = end(&mut window).await;
            assert_eq!(
                (&section["ended"], &*printed),
                (&json!("stopped"), ""),
                "{text} after {} ms",
                4 * k
            );
        }
    }
    alive(&mut window).await;
}

#[tokio::test]
async fn nothing_that_a_script_does_to_itself_reaches_the_studio() {
    let Some(mut window) = ready("ar3").await else {
        return;
    };
    for (text, words) in [
        ("import os\nos._exit(7)\n", "code 7"),
        (
            "import os, signal\nos.kill(os.getpid(), signal.SIGKILL)\n",
            "killed",
        ),
        ("import os\nos.close(3)\nos.close(4)\n", ""),
        ("import os\nos.write(3, b'x' * 3000000)\n", ""),
        ("import sys\nsys.exit(3)\n", "code 3"),
    ] {
        let (section, _) = run(&mut window, text).await;
        assert!(
            section["ended"].as_str().unwrap().contains(words),
            "{text}: {section}"
        );
    }
    let (section, printed) = run(
        &mut window,
        "import sys\nfor _ in range(1000): sys.stdout.write('y' * 99999 + '\\n')\n",
    )
    .await;
    assert!(section["error"].is_null(), "{section}");
    assert!(
        printed.len() < (1 << 20) + 200 && printed.contains("megabyte"),
        "{}",
        printed.len()
    );
    alive(&mut window).await;
}

#[tokio::test]
async fn one_script_at_a_time() {
    let Some(mut window) = ready("ar3").await else {
        return;
    };
    say(
        &mut window,
        json!({"do": "script_run", "text": "import time\ntime.sleep(30)"}),
    )
    .await;
    until(&mut window, |value| {
        value["section"] == "script" && value["value"]["running"] == true
    })
    .await;
    say(
        &mut window,
        json!({"id": 5, "do": "script_run", "text": ""}),
    )
    .await;
    let answer = until(&mut window, |value| value["ack"] == 5).await;
    assert!(
        answer["error"].as_str().unwrap().contains("stop it first"),
        "{answer}"
    );
    say(&mut window, json!({"do": "script_stop"})).await;
    until(&mut window, |value| {
        value["section"] == "script" && value["value"]["running"] == false
    })
    .await;
}
