const find = (selector, top = document) => top.querySelector(selector);
const find_all = (selector, top = document) => [...top.querySelectorAll(selector)];
const element = (name, properties = {}, ...children) => {
    const made = Object.assign(document.createElement(name), properties);
    made.append(...children);
    return made;
};
const announce = (text) => { find("#announcement").textContent = text; };

const checks = find_all("details.check");
const cases = find_all("section.case");
const list = find("#checks");

// The body of a check is text until it is needed: a page of thousands of checks opens at once.
function fill(check) {
    const text = find("noscript", check);
    if (!text) return;
    const body = document.createElement("template");
    body.innerHTML = text.textContent;  // escaped by the program
    text.replaceWith(body.content);
}

// The state of the page is its hash, so that a link shows the same.
const state = { q: "", s: null, order: "severity", c: "", v: 0 };

function read_hash() {
    const hash = new URLSearchParams(location.hash.slice(1));
    state.q = hash.get("q") ?? "";
    state.s = hash.has("s") ? hash.get("s").split(",") : null;
    state.order = hash.get("order") ?? "severity";
    state.c = hash.get("c") ?? "";
    state.v = Math.max(view_names.findIndex((name) => name.id === hash.get("v")), 0);
}

function write_hash() {
    const hash = new URLSearchParams();
    if (state.q) hash.set("q", state.q);
    if (state.s) hash.set("s", state.s.join(","));
    if (state.order !== "severity") hash.set("order", state.order);
    if (state.c) hash.set("c", state.c);
    if (state.v) hash.set("v", view_names[state.v].id);
    history.replaceState(null, "", "#" + hash);
}

// Filters and order

const chips = find_all(".chip");
const search = find("#search");
const order = find("#order");

const shown_checks = () => checks.filter((check) => !check.hidden);
const is_pressed = (chip) => chip.getAttribute("aria-pressed") === "true";

// Text of a check that is searched, in lower case.
const searched = new Map(checks.map((check) => [check,
    `${check.id} ${find(".message", check).textContent} ${check.dataset.nodes}`.toLowerCase()]));

// All words, and none of those after "!".
function matcher(query) {
    const words = query.toLowerCase().split(/\s+/).filter((word) => word.replace("!", ""));
    return (text) => words.every((word) =>
        word.startsWith("!") ? !text.includes(word.slice(1)) : text.includes(word));
}

function apply_filters() {
    const matches = matcher(state.q);
    const allowed = new Set(chips.filter(is_pressed).map((chip) => chip.dataset.status));
    for (const check of checks)
        check.hidden = !(allowed.has(check.dataset.status) && matches(searched.get(check)));
    for (const each of cases) each.hidden = !find("details.check:not([hidden])", each);
    find("#none").hidden = shown_checks().length > 0;
    const passed = find("#passed");
    if (!passed) return;
    passed.hidden = !allowed.has("passed");
    if (passed.hidden) return;
    for (const item of find_all("li", passed))
        item.hidden = !matches(item.textContent.toLowerCase());
}

function apply_order() {
    const seconds = (each) =>
        find_all("details.check", each).reduce((sum, check) => sum + +check.dataset.seconds, 0);
    const times = state.order === "time" ? new Map(cases.map((each) => [each, seconds(each)])) : null;
    const orders = {
        name: (a, b) => a.dataset.name < b.dataset.name ? -1 : 1,
        time: (a, b) => times.get(b) - times.get(a),
    };
    const ordered = orders[state.order] ? [...cases].sort(orders[state.order]) : cases;
    if (ordered.some((each, i) => list.children[i] !== each)) list.append(...ordered);
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
    if (!check?.matches("details.check")) return;
    const view = state.v;
    select(check);
    viewers.get(check)?.show(view);
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
    if (check === current) return;
    current?.classList.remove("current");
    current = check;
    check.classList.add("current");
    state.c = check.id;
    state.v = viewers.get(check)?.view ?? 0;
    write_hash();
}

function select(check) {
    check.open = true;
    open_body(check);
    make_current(check);
    find("summary", check).focus();
    check.scrollIntoView({ block: check.offsetHeight > innerHeight ? "start" : "nearest" });
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

const accept = find("#accept");
const review = accept?.textContent ?? "";  // two graphs: nothing is accepted
const test_command = review.replace(/ --review$/, "");

function choose(check) {
    if (!("acceptable" in check.dataset)) {
        announce("Not acceptable: budgets are limits, and errors and changes have no baseline");
        return;
    }
    if (!chosen.delete(check.id)) chosen.add(check.id);
    check.classList.toggle("chosen", chosen.has(check.id));
    const button = find(".choose", check);
    if (button) button.setAttribute("aria-pressed", chosen.has(check.id));
    const ids = [...chosen].map(quoted).join(" ");
    accept.textContent = ids ? `${test_command} --accept ${ids}` : review;
    announce(chosen.size + " in the accept command");
}

// For those who do not use keys.
function add_choice(check) {
    if (!("acceptable" in check.dataset)) return;
    const button = element("button", { type: "button", className: "choose",
        textContent: "Add to the accept command" });
    button.setAttribute("aria-pressed", chosen.has(check.id));
    button.addEventListener("click", () => choose(check));
    find(".source", check).append(button);
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

// Keys of one character can be turned off, for speech input (WCAG 2.1.4).
const has_keys = find("#has-keys");

function actions_of(event) {
    const view = current?.open ? viewers.get(current) : null;
    const actions = {
        j: () => step(1),
        k: () => step(-1),
        a: () => current && choose(current),
        "/": () => search.focus(),
        "?": () => help.showModal(),
    };
    if (!view) return actions;
    Object.assign(actions, {
        f: () => view.fit(),
        "+": () => view.zoom_by(2),
        "-": () => view.zoom_by(0.5),
    });
    if (event.key >= "1" && event.key <= "6")
        actions[event.key] = () => view.show(event.key - 1);
    if (view.is_stacked() && !event.target.matches("button")) actions[" "] = () => view.exchange();
    return actions;
}

document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || help.open) return;
    if (event.target.matches("input, select")) {
        if (event.key === "Escape") event.target.blur();
        return;
    }
    const action = has_keys.checked ? actions_of(event)[event.key] : null;
    if (!action) return;
    event.preventDefault();
    action();
});

window.addEventListener("hashchange", () => {
    read_hash();
    apply_state();
});
