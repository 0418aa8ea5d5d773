"use strict";
let events = null, newest = 0;
const element = id => document.getElementById(id);

function show_line(text, kind) {
  element("line").textContent = text;
  document.body.className = kind;
}

async function part(output, index, build) {
  const address = `/output/${index}?build=${build}`;
  const section = document.createElement("section");
  const heading = section.appendChild(document.createElement("h2"));
  heading.textContent = output.name;
  if (output.kind === "image") {
    const image = section.appendChild(document.createElement("img"));
    image.alt = output.name;
    image.src = address;
    await image.decode().catch(() => {});
  } else if (output.kind === "page") {
    const frame = section.appendChild(document.createElement("iframe"));
    frame.title = output.name;
    frame.setAttribute("sandbox", "allow-scripts");
    frame.src = address;
  } else if (output.kind === "text") {
    const text = section.appendChild(document.createElement("pre"));
    text.tabIndex = 0;
    text.textContent = await (await fetch(address)).text();
  }
  return section;
}

// The former outputs stay until the new ones are complete.
async function refresh() {
  const mine = ++newest;
  const state = await (await fetch("/state")).json();
  if (state.line === undefined) return;
  const text = element("text");
  text.textContent = state.text;
  text.hidden = state.text === "";
  show_line(state.line, (state.ok ? "good" : "bad") + (state.made_outputs ? "" : " former"));
  document.title = (state.ok ? "" : "\u2717 ") + state.command + " \u2013 wrinkle watch";
  if (!state.made_outputs && element("outputs").childElementCount > 0) return;
  const parts = await Promise.all(state.outputs.map((o, i) => part(o, i, state.build)));
  if (mine === newest) element("outputs").replaceChildren(...parts);
}

// A browser opens six connections to a host over all its tabs: a hidden one gives its back.
function connect() {
  if (document.hidden) {
    if (events) events.close();
    events = null;
  } else if (!events) {
    events = new EventSource("/events");
    events.onmessage = () => refresh().catch(lost);
    events.onerror = lost;
  }
}

function lost() {
  show_line("no connection; is wrinkle watch running?", "bad former");
  document.title = "\u2717 no connection \u2013 wrinkle watch";
}

document.addEventListener("visibilitychange", connect);
connect();
refresh().catch(lost);
