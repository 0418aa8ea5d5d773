"use strict";

const find = (selector, top = document) => top.querySelector(selector);
const find_all = (selector, top = document) => [...top.querySelectorAll(selector)];
const element = (name, properties = {}, ...children) => {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
};
const announce = (text) => { find("#announcement").textContent = text; };

const checks = find_all("details.check");
const list = find("#checks");

// The state of the page is its hash, so that a link shows the same.
const state = { q: "", s: null, order: "severity", c: "" };

function read_hash() {
    const hash = new URLSearchParams(location.hash.slice(1));
    state.q = hash.get("q") ?? "";
    state.s = hash.has("s") ? hash.get("s").split(",") : null;
    state.order = hash.get("order") ?? "severity";
    state.c = hash.get("c") ?? "";
}

function write_hash() {
    const hash = new URLSearchParams();
    if (state.q) hash.set("q", state.q);
    if (state.s) hash.set("s", state.s.join(","));
    if (state.order !== "severity") hash.set("order", state.order);
    if (state.c) hash.set("c", state.c);
    history.replaceState(null, "", "#" + hash);
}

// Filters and order

const chips = find_all(".chip");
const search = find("#search");
const order = find("#order");

const shown_checks = () => checks.filter((check) => !check.hidden);
const is_pressed = (chip) => chip.getAttribute("aria-pressed") === "true";

function apply_filters() {
    const words = state.q.toLowerCase().split(/\s+/).filter(Boolean);
    const matches = (text) => words.every((word) => text.toLowerCase().includes(word));
    const allowed = new Set(chips.filter(is_pressed).map((chip) => chip.dataset.status));
    for (const check of checks) {
        const text = check.id + " " + (find(".message", check)?.textContent ?? "");
        check.hidden = !(allowed.has(check.dataset.status) && matches(text));
    }
    const passed = find("#passed");
    if (!passed) return;
    passed.hidden = !allowed.has("passed");
    if (passed.hidden) return;
    for (const item of find_all("li", passed)) item.hidden = !matches(item.textContent);
}

function apply_order() {
    const keys = {
        severity: () => 0,
        name: (a, b) => a.id.localeCompare(b.id),
        time: (a, b) => b.dataset.seconds - a.dataset.seconds,
    };
    list.append(...[...checks].sort(keys[state.order] ?? keys.severity));
}

function apply_state() {
    search.value = state.q;
    order.value = state.order;
    if (state.s)
        for (const chip of chips)
            chip.setAttribute("aria-pressed", state.s.includes(chip.dataset.status));
    apply_filters();
    apply_order();
    const check = document.getElementById(state.c);
    if (check?.matches("details.check")) select(check);
}

for (const chip of chips)
    chip.addEventListener("click", () => {
        chip.setAttribute("aria-pressed", !is_pressed(chip));
        state.s = chips.filter(is_pressed).map((each) => each.dataset.status);
        apply_filters();
        write_hash();
    });
search.addEventListener("input", () => {
    state.q = search.value;
    apply_filters();
    write_hash();
});
order.addEventListener("change", () => {
    state.order = order.value;
    apply_order();
    write_hash();
});

// The current check

let current = null;

function make_current(check) {
    current?.classList.remove("current");
    current = check;
    check.classList.add("current");
    state.c = check.id;
    write_hash();
}

function select(check) {
    make_current(check);
    check.open = true;
    find("summary", check).focus();
    check.scrollIntoView({ block: "nearest" });
}

function step(direction) {
    const shown = find_all("details.check", list).filter((check) => !check.hidden);
    if (shown.length === 0) return;
    const at = shown.indexOf(current);
    const next = at < 0 ? 0 : Math.min(Math.max(at + direction, 0), shown.length - 1);
    select(shown[next]);
}

// Commands

const chosen = new Set();

const is_plain = (word) => /^[\w./+,:@%-]+$/.test(word);
const quoted = (word) => is_plain(word) ? word : "'" + word.replaceAll("'", "'\\''") + "'";

function choose(check) {
    if (!chosen.delete(check.id)) chosen.add(check.id);
    check.classList.toggle("chosen", chosen.has(check.id));
    const ids = [...chosen].map(quoted).join(" ");
    find("#accept").textContent = "wrinkle test " + (ids ? "--accept " + ids : "--review");
    announce(chosen.size + " in the accept command");
}

for (const button of find_all("[data-copy]"))
    button.addEventListener("click", async () => {
        const code = document.getElementById(button.dataset.copy);
        try {
            await navigator.clipboard.writeText(code.textContent);
            announce("Copied");
        } catch {
            getSelection().selectAllChildren(code);
            announce("Selected; copy it with Ctrl+C");
        }
    });

// Keys

const help = find("#help");
find("#help-button").addEventListener("click", () => help.showModal());

document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || help.open) return;
    if (event.target.matches("input, select")) {
        if (event.key === "Escape") event.target.blur();
        return;
    }
    const view = current && viewers.get(current);
    const keys = {
        j: () => step(1),
        k: () => step(-1),
        a: () => current && choose(current),
        "/": () => search.focus(),
        "?": () => help.showModal(),
        f: () => view?.fit(),
        "+": () => view?.zoom_by(2),
        "-": () => view?.zoom_by(0.5),
    };
    if (view && event.key >= "1" && event.key <= "6")
        keys[event.key] = () => view.show(event.key - 1);
    if (view?.is_stacked() && !event.target.matches("button")) keys[" "] = () => view.exchange();
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
});

window.addEventListener("hashchange", () => {
    read_hash();
    apply_state();
});
