#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plays the playground in a browser without a window and without a network, and holds it against the terminal.

tests/playground/run.py PAGE TERMINAL
tests/playground/run.py PAGE --control TERMINAL  the same with faults planted in the page, which have to be found
tests/playground/run.py PAGE --pictures FOLDER   draws the pictures of the games that are in docs
  PAGE      playground.html, from examples/run.sh playground
  TERMINAL  shapes-pinball, built with any compiler
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
FRAMES = 3600  # a minute of each game on each engine

# Faults as they are planted in the page, and a word of what has to be found.
PLANTED = [
    ("engine._SetMode(mode);", "engine._SetMode(mode); engine._Frame(0);", "balls moved"),
    ("const keys = nextKeys();", "const keys = nextKeys() & 3;", "no points"),
    ("if (kind === 'm') setMode(value);", "", "replay ended differently"),
    ("held.delete(`${keyNames[event.code]} ${event.code}`)", "held.clear()", "one was let go"),
    (" || state.isWatched || (state.replay && bits === 0)", "", "keys after the mouse"),
    ("if (location.hash !== ownHash) openAddress();", "", "links in the address"),
    ("location.hash = ownHash = ", "location.hash = ", "links in the address"),
    ("engine._GetBallCount() === 0; //", "false; //", "a scene can be saved"),
    ("normal: [nx, ny], setback,", "normal: [nx, ny], setback: 2 * setback,", "native is set back"),
    ("return (-b - sign * root) / a;", "return (-b - root) / a;", "native answers as exactly"),
    ("  makePads();\n", "  makePads();\n  console.error('planted');\n", "planted"),
    ("  makePads();\n", "  makePads();\n  fetch('https://example.org').catch(() => {});\n", "https://example.org"),
]


def hash_of(text):
    value = 2166136261
    for byte in text:
        value = (value ^ byte) * 16777619 & 0xFFFFFFFF
    return value


def exercised(page, script):
    text = page.read_text()
    watch = f"<script>window.minute = {FRAMES};\n{(HERE / 'watch.js').read_text()}</script>\n"
    first, last = text.index("<script>"), text.rindex("</script>")
    return text[:first] + watch + text[first:last] + script + text[last:]


def run_browser(page, folder, script, *arguments):
    file = folder / "page.html"
    file.write_text(exercised(page, script))
    browser = next((path for name in ("chromium-headless-shell", "chromium", "google-chrome") if (path := shutil.which(name))), None)
    if browser is None:
        sys.exit("There is no Chromium: install chromium-headless-shell")
    offline = ["unshare", "-rn"] if subprocess.run(["unshare", "-rn", "true"], capture_output=True).returncode == 0 else []
    return subprocess.run(offline + [
        browser, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--host-resolver-rules=MAP * ~NOTFOUND",
        "--hide-scrollbars", "--blink-settings=preferredColorScheme=1", f"--user-data-dir={folder / 'profile'}", "--timeout=600000", *arguments,
        f"file://{file}"], capture_output=True, text=True, timeout=900, check=True)


def exercise(page, folder):
    done = run_browser(page, folder, (HERE / "exercise.js").read_text(), "--window-size=1280,720", "--dump-dom")
    found = re.search(r'<pre id="test-result">(.*?)</pre>', done.stdout, re.S)
    if not found:
        sys.exit(f"The page left no result; the browser says: {done.stderr[-2000:]}")
    return json.loads(found[1])


def draw_pictures(page, folder, pictures):
    for game, frames in {"pinball": 700, "pile": 240, "billiard": 600, "breakout": 1500}.items():
        script = f"""start(games.indexOf('{game}'), 0, 1); setPaused(true); setWatched(true);
            for (let i = 0; i < {frames}; ++i) playFrame();
            show(); window.holder.contentDocument.close();"""
        run_browser(page, folder, script, "--window-size=320,600", f"--screenshot={pictures / f'{game}.png'}")


def run_terminal(terminal, folder, game, mode, seed="1"):
    trace = folder / "trace"
    subprocess.run([terminal, "--game", game, "--engine", mode, "--seed", seed, "--frames", str(FRAMES), "--trace", trace],
                   check=True, capture_output=True)
    return hash_of(trace.read_bytes())


def plant(page, folder):
    text = page.read_text()
    for good, bad, _ in PLANTED:
        assert good in text, good
        text = text.replace(good, bad)
    planted = folder / "planted.html"
    planted.write_text(text)
    return planted


def faults_of_toy(toy):
    native, box2d = toy["contacts"]
    near = lambda a, b: all(abs(x - y) < 1e-5 for x, y in zip(a, b, strict=True))
    checks = {
        "only the sweeps meet what is on the way": toy["swept"] == {name: name != "native-approximate" for name in toy["swept"]},
        "the ball is where it was dragged": near(toy["dragged"], [1, 3]),
        "native meets at the closest point": native["isMet"] and near(native["poi"], [1, 2.5]) and near(native["normal"], [0, 1]),
        "native is set back by what it overlaps": near([native["setback"]], [0.3]),
        "Box2D meets within its slop": box2d["isMet"] and near(box2d["normal"], [0, 1]) and abs(box2d["setback"] - 0.3) < 0.02,
        "common tangents of equal circles are level": sorted(round(end, 4) for t in toy["tangents"] for end in t[1::2]) == [2.2, 2.2, 3.8, 3.8],
        "the centre is in one sector, and not in the other": toy["isInSector"] == [True, False],
        "both engines and the exact answer are named": all(name in toy["text"] for name in ("native", "box2d", "exact")),
        "native answers as exactly": toy["exact"]["differing"] == [] and min(toy["exact"]["met"].values()) > 100,
        "odd scenes are refused in words": len(toy["refused"]) == 3 and all("expected" in words for words in toy["refused"]),
        "a shape is deleted": toy["deleted"] == 1,
        "nothing sticks out": toy["width"] == 0,
    }
    return [f"toy: not so: {what}: {toy}" for what, holds in checks.items() if not holds]


def faults_of(seen, hashes):
    faults = []

    def expect(holds, what):
        if not holds:
            faults.append(what)

    expect(seen["isDone"], "the exercise did not get to its end")
    expect(not seen["errors"], f"errors: {seen['errors']}")
    expect(not seen.get("resources"), f"fetched: {seen.get('resources')}")
    if not seen["isDone"]:
        return faults
    expect(seen["step"] == 1 and seen["keys"] == 1, f"a step was {seen['step']} frames with the keys {seen['keys']}")
    expect(seen["stillHeld"] == 1, f"of two keys by one name one was let go, and the keys are {seen['stillHeld']}")
    expect(seen["canSave"] == [True, False], f"a scene can be saved with a ball, and with none: {seen['canSave']}")
    # To the right; then nothing, the left key of the replay, and the serve of the scripted player.
    expect(seen["mouse"] == {"mine": 2, "started": 0, "replayed": 1, "watched": 4}, f"keys after the mouse has moved: {seen['mouse']}")
    expect(seen["address"] == {"copied": False, "pasted": True, "game": "breakout"}, f"links in the address: {seen['address']}")
    expect(all("expected" in words for words in seen["refused"]), f"links: {seen['refused']}")
    faults += faults_of_toy(seen["toy"])
    expect(hashes["pinball"]["native"] != hashes["control"], "a pinball of another seed has the same trace")
    for game, result in seen["games"].items():
        expect(result["jumps"] == [], f"{game}: balls moved when the engine was switched to {result['jumps']}")
        expect(result["replay"] == "same", f"{game}: the replay ended differently: {result['replay']}")
        expect(result["ink"] > 2000, f"{game}: {result['ink']} pixels are drawn")
        expect(result["width"] == 0, f"{game}: the page is {result['width']} pixels too wide")
        for mode, played in result["modes"].items():
            expect(played["score"] > 0, f"{game} on {mode}: no points")
            expect(played["hash"] == hashes[game][mode], f"{game} on {mode}: not the trace of the terminal")
            expect((played["lost"] == 0) == ("No ball" in played["told"]), f"{game} on {mode}: {played['lost']} lost, told: {played['told']}")
            expect(mode == "native-approximate" or played["lost"] == 0, f"{game} on {mode}: {played['lost']} balls lost")
    return faults


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    page, last = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[-1]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        if sys.argv[2] == "--pictures":
            draw_pictures(page, folder, last)
            return
        is_control, terminal = sys.argv[2] == "--control", last
        seen = exercise(plant(page, folder) if is_control else page, folder)
        hashes = {game: {mode: run_terminal(terminal, folder, game, mode) for mode in result["modes"]}
                  for game, result in seen["games"].items()}
        hashes["control"] = run_terminal(terminal, folder, "pinball", "native", seed="2")
    faults = faults_of(seen, hashes)
    for game, result in seen["games"].items():
        # Frames a second depend on who else uses the machine: they are shown, not judged.
        print(game, {mode: (played["score"], played["lost"]) for mode, played in result["modes"].items()}, result.get("speed", ""))
    if is_control:
        missed = [word for _, _, word in PLANTED if not any(word in fault for fault in faults)]
        if missed:
            sys.exit(f"Planted, and not found: {missed}")
        print("All that was planted is found.")
        return
    if faults:
        sys.exit("\n".join(faults))
    print("The page plays as the terminal does.")


if __name__ == "__main__":
    main()
