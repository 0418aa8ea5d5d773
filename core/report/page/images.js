// Views of the images of a check. A viewer is made when its check is opened first.

const view_names = [
    { id: "side", text: "Side by side" },
    { id: "swipe", text: "Swipe" },
    { id: "onion", text: "Onion skin" },
    { id: "blink", text: "Blink" },
    { id: "difference", text: "Difference" },
    { id: "map", text: "Map" },
];
const [side, swipe, onion, blink, difference, map] = view_names.keys();
const still = matchMedia("(prefers-reduced-motion: reduce)");
const fit_width = 384;
const viewers = new Map();

function tool(text, label, use) {
    const button = element("button", { type: "button", textContent: text });
    button.setAttribute("aria-label", label);
    button.addEventListener("click", use);
    return button;
}

function labelled(made, label, event, use) {
    made.setAttribute("aria-label", label);
    made.addEventListener(event, use);
    return made;
}

class Viewer {
    constructor(box) {
        this.box = box;
        this.figures = ["expected", "actual", "map"].map((name) => find("." + name, box));
        this.images = this.figures.map((figure) => figure && find("img", figure));
        this.frames = this.images.map((image) => image?.closest(".frame"));
        // "Expected" and "Actual", or "Before" and "After"
        this.names = this.figures.slice(0, 2).map((figure) =>
            figure ? find("figcaption", figure).textContent : "");
        this.has_pair = Boolean(this.images[0] && this.images[1]);
        const present = this.images.filter(Boolean);
        this.width = Math.max(...present.map((image) => +image.getAttribute("width")));
        this.height = Math.max(...present.map((image) => +image.getAttribute("height")));
        this.unit = box.dataset.measure === "degrees" ? " degrees" : "";
        this.stack = element("div", { className: "stack" });
        this.stacked = element("figure", {}, this.stack, element("figcaption"));
        this.values = element("div", { className: "values" });
        this.panel = element("div", { className: "panel", tabIndex: 0, id: `panel-${viewers.size}` },
            ...this.figures.filter(Boolean), this.stacked);
        this.panel.setAttribute("role", "tabpanel");
        this.make_tools();
        box.append(this.tools, this.panel, this.values);
        this.listen();
        this.fit();
        this.show(side);
        if (this.images[2]) this.add_scale();
    }

    make_tools() {
        this.tabs = view_names.map(({ text }, i) => {
            const tab = element("button", { type: "button", textContent: text,
                id: `${this.panel.id}-${i}`, disabled: !this.has_view(i) });
            tab.setAttribute("role", "tab");
            tab.setAttribute("aria-controls", this.panel.id);
            tab.addEventListener("click", () => this.show(i));
            return tab;
        });
        const group = element("div", {}, ...this.tabs);
        group.setAttribute("role", "tablist");
        group.setAttribute("aria-label", "Views of the images");
        group.addEventListener("keydown", (event) => this.step_tab(event));
        this.slider = labelled(element("input", { type: "range", min: 0, max: 100, value: 50 }),
            "Part of the second image", "input", () => this.update());
        const factors = [1, 4, 16].map((n) => element("option", { value: n, textContent: "× " + n }));
        this.factor = labelled(element("select", {}, ...factors),
            "Factor of the difference", "change", () => this.update());
        this.tools = element("div", { className: "tools" }, group, this.slider, this.factor,
            tool("+", "Zoom in", () => this.zoom_by(2)),
            tool("\u2212", "Zoom out", () => this.zoom_by(0.5)),
            tool("Fit", "Fit", () => this.fit()));
    }

    async add_scale() {
        const image = this.images[2];
        try {
            await image.decode();
            find("figcaption", this.figures[2]).after(
                scale_of_map(image, Number(this.box.dataset.scale), this.unit));
        } catch {
            announce("The map cannot be shown");
        }
    }

    listen() {
        this.panel.addEventListener("pointermove", (event) => this.point(event));
        this.panel.addEventListener("pointerleave", () => { this.values.textContent = ""; });
        this.panel.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
        this.panel.addEventListener("keydown", (event) => this.move(event));
        this.panel.addEventListener("dragstart", (event) => event.preventDefault());
    }

    has_view(view) {
        return view === side || (view === map ? Boolean(this.images[2]) : this.has_pair);
    }

    is_stacked() { return this.view >= swipe && this.view <= difference; }

    show(view) {
        if (!this.has_view(view)) return;
        this.view = view;
        this.tabs.forEach((tab, i) => {
            tab.setAttribute("aria-selected", i === view);
            tab.tabIndex = i === view ? 0 : -1;
        });
        this.panel.setAttribute("aria-labelledby", this.tabs[view].id);
        clearInterval(this.timer);
        this.timer = null;
        const stacked = this.is_stacked();
        this.figures.forEach((figure, i) => {
            if (!figure) return;
            figure.hidden = stacked || (view === map && i !== 2);
            const frame = this.frames[i];
            if (stacked && i < 2) this.stack.append(frame);
            else if (frame && frame.parentNode !== figure) figure.prepend(frame);
        });
        this.stacked.hidden = !stacked;
        this.stack.classList.toggle("difference", view === difference);
        this.slider.hidden = view !== swipe && view !== onion;
        this.factor.hidden = view !== difference;
        this.actual_shown = true;
        if (view === blink && !still.matches) this.timer = setInterval(() => this.blink(), 500);
        this.update();
        if (current && viewers.get(current) === this) {
            state.v = view;
            write_hash();
        }
    }

    // Arrows choose the tab, as in the ARIA pattern of tabs.
    step_tab(event) {
        const direction = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
        if (!direction) return;
        event.preventDefault();
        let view = this.view;
        do view = (view + direction + this.tabs.length) % this.tabs.length;
        while (!this.has_view(view));
        this.show(view);
        this.tabs[view].focus();
    }

    // Shows one image, then the other.
    exchange() {
        if (this.view === blink && this.timer) {
            clearInterval(this.timer);
            this.timer = null;
            announce("Stopped");
        } else if (this.view === blink) {
            this.blink();
            announce(this.names[this.actual_shown ? 1 : 0]);
        } else {
            this.slider.value = this.slider.value < 50 ? 100 : 0;
            this.update();
        }
    }

    blink() {
        if (!this.box.closest("details").open) return;
        this.actual_shown = !this.actual_shown;
        this.update();
    }

    update() {
        const scale = this.fitted * this.zoom;
        this.frames.forEach((frame, i) => {
            if (!frame) return;
            const image = this.images[i];
            frame.style.width = image.getAttribute("width") * this.fitted + "px";
            frame.style.height = image.getAttribute("height") * this.fitted + "px";
            frame.classList.toggle("pixels", scale >= 2);
            image.style.transform =
                `translate(${-this.pan[0] * scale}px, ${-this.pan[1] * scale}px) scale(${scale})`;
        });
        if (this.has_pair) this.update_stack(this.frames[1].style);
    }

    update_stack(actual) {
        const part = Number(this.slider.value);
        const first = this.view === blink && !this.actual_shown;
        this.stack.style.filter = this.view === difference ? `brightness(${this.factor.value})` : "";
        this.stack.classList.toggle("first", first);
        this.stack.classList.toggle("second", this.view === blink && !first);
        actual.clipPath = this.view === swipe ? `inset(0 0 0 ${100 - part}%)` : "";
        actual.opacity = this.view === onion ? part / 100 : 1;
        actual.visibility = first ? "hidden" : "";
        const [one, other] = [this.names[0], this.names[1].toLowerCase()];
        find("figcaption", this.stacked).textContent = {
            [swipe]: `${one} left, ${other} right`,
            [onion]: `${one} below, ${other} above`,
            [blink]: this.names[first ? 0 : 1],
            [difference]: "Difference of the colors",
        }[this.view] ?? "";
    }

    fit() {
        const scale = fit_width / Math.max(this.width, this.height);
        this.fitted = scale >= 1 ? Math.floor(scale) : scale;
        this.zoom = 1;
        this.pan = [0, 0];
        this.update();
    }

    pan_to(pan) {
        this.pan = pan.map((value, i) => {
            const size = i === 0 ? this.width : this.height;
            return Math.min(Math.max(value, 0), size - size / this.zoom);
        });
        this.update();
    }

    zoom_by(factor, at = [this.pan[0] + this.width / 2 / this.zoom,
        this.pan[1] + this.height / 2 / this.zoom]) {
        const zoom = Math.min(Math.max(this.zoom * factor, 1), 64);
        const before = this.zoom;
        this.zoom = zoom;
        this.pan_to(this.pan.map((pan, i) => at[i] - (at[i] - pan) * before / zoom));
    }

    move(event) {
        const direction = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1],
            ArrowDown: [0, 1] }[event.key];
        if (!direction || this.zoom === 1) return;
        event.preventDefault();
        const step = this.width / this.zoom / 8;
        this.pan_to(this.pan.map((pan, i) => pan + direction[i] * step));
    }

    // Returns the pixel under the pointer, or null.
    pixel(event) {
        const frame = event.target.closest(".frame");
        if (!frame) return null;
        const box = frame.getBoundingClientRect();
        const scale = this.fitted * this.zoom;
        return [Math.floor((event.clientX - box.left - frame.clientLeft) / scale + this.pan[0]),
            Math.floor((event.clientY - box.top - frame.clientTop) / scale + this.pan[1])];
    }

    point(event) {
        const pixel = this.pixel(event);
        const scale = this.fitted * this.zoom;
        if (event.buttons === 1 && pixel)
            this.pan_to([this.pan[0] - event.movementX / scale, this.pan[1] - event.movementY / scale]);
        this.values.textContent = pixel ? this.text_at(...pixel) : "";
    }

    wheel(event) {
        const pixel = this.pixel(event);
        if (!pixel || !(event.ctrlKey || this.zoom > 1)) return;
        event.preventDefault();
        this.zoom_by(event.deltaY < 0 ? 1.25 : 0.8, pixel);
    }

    text_at(x, y) {
        if (this.images.some((image) => image && !image.naturalWidth)) return "";
        this.pixels ??= this.images.map((image) => image && pixels_of(image));
        const [expected, actual, error] = this.pixels.map((data) => data && texel(data, x, y));
        let text = `${x}, ${y}`;
        const [one, other] = this.names.map((name) => name.toLowerCase());
        if (expected) text += `   ${one} ${expected.join(" ")}`;
        if (actual) text += `   ${other} ${actual.join(" ")}`;
        if (expected && actual && this.unit)
            text += `   about ${degrees_between(expected, actual).toFixed(1)} degrees`;
        if (error) {
            const value = step_of(error) * Number(this.box.dataset.scale) / 255;
            text += `   map ${value.toPrecision(3)}${this.unit}`;
        }
        return text;
    }
}
