// Views of the images of a check. A viewer is made when its check is opened first.

const view_names = ["Side by side", "Swipe", "Onion skin", "Blink", "Difference", "Map"];
const still = matchMedia("(prefers-reduced-motion: reduce)");
const fit_width = 384;
const viewers = new Map();

function pixels_of(image) {
    const canvas = element("canvas", { width: image.naturalWidth, height: image.naturalHeight });
    const context = canvas.getContext("2d", { willReadFrequently: true });
    context.drawImage(image, 0, 0);
    return context.getImageData(0, 0, canvas.width, canvas.height);
}

function degrees_between(a, b) {
    const [u, v] = [a, b].map((texel) => texel.map((value) => value / 127.5 - 1));
    const dot = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    const length = Math.hypot(...u) * Math.hypot(...v);
    return length > 0 ? Math.acos(Math.min(1, dot / length)) * 180 / Math.PI : 0;
}

class Viewer {
    constructor(box) {
        this.box = box;
        this.figures = ["expected", "actual", "map"].map((name) => find("." + name, box));
        this.images = this.figures.map((figure) => figure && find("img", figure));
        this.has_pair = this.images[0] && this.images[1];
        this.has_map = Boolean(this.images[2]);
        this.width = this.images.find(Boolean)?.naturalWidth || 1;
        this.height = this.images.find(Boolean)?.naturalHeight || 1;
        this.zoom = 1;
        this.pan = [0, 0];
        this.stack = element("div", { className: "stack" });
        this.stacked = element("figure", {}, this.stack, element("figcaption"));
        this.values = element("div", { className: "values" });
        this.make_tools();
        box.prepend(this.tools);
        box.append(this.stacked, this.values);
        box.addEventListener("pointermove", (event) => this.point(event));
        box.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
        this.fit();
        this.show(0);
    }

    make_tools() {
        this.tabs = view_names.map((name, i) => {
            const tab = element("button", { type: "button", textContent: name });
            tab.setAttribute("role", "tab");
            tab.disabled = i > 0 && (i < 5 ? !this.has_pair : !this.has_map);
            tab.addEventListener("click", () => this.show(i));
            return tab;
        });
        const group = element("div", {}, ...this.tabs);
        group.setAttribute("role", "tablist");
        group.setAttribute("aria-label", "Views of the images");
        this.slider = element("input", { type: "range", min: 0, max: 100, value: 50 });
        this.slider.setAttribute("aria-label", "Part of the actual image");
        this.slider.addEventListener("input", () => this.update());
        this.factor = element("select", {},
            ...[1, 4, 16].map((n) => element("option", { value: n, textContent: "× " + n })));
        this.factor.setAttribute("aria-label", "Factor of the difference");
        this.factor.addEventListener("change", () => this.update());
        const button = (text, label, use) => {
            const made = element("button", { type: "button", textContent: text });
            made.setAttribute("aria-label", label);
            made.addEventListener("click", use);
            return made;
        };
        this.tools = element("div", { className: "tools" }, group, this.slider, this.factor,
            button("+", "Zoom in", () => this.zoom_by(2)),
            button("\u2212", "Zoom out", () => this.zoom_by(0.5)),
            button("Fit", "Fit", () => this.fit()));
    }

    is_stacked() { return this.view >= 1 && this.view <= 4; }

    show(view) {
        if (this.tabs[view].disabled) return;
        this.view = view;
        this.tabs.forEach((tab, i) => tab.setAttribute("aria-selected", i === view));
        clearInterval(this.timer);
        const stacked = this.is_stacked();
        this.figures.forEach((figure, i) => {
            if (!figure) return;
            figure.hidden = stacked || (view === 5 && i !== 2);
            const frame = this.frames?.[i] ?? find(".frame", figure);
            if (!frame) return;
            this.frames = Object.assign(this.frames ?? [], { [i]: frame });
            if (stacked && i < 2) this.stack.append(frame);
            else if (frame.parentNode !== figure) figure.prepend(frame);
        });
        this.stacked.hidden = !stacked;
        this.stack.classList.toggle("difference", view === 4);
        this.slider.hidden = view !== 1 && view !== 2;
        this.factor.hidden = view !== 4;
        this.actual_shown = true;
        if (view === 3 && !still.matches) this.timer = setInterval(() => this.blink(), 500);
        this.update();
    }

    // Shows one image, then the other.
    exchange() {
        if (this.view === 3 && this.timer) {
            clearInterval(this.timer);
            this.timer = null;
            announce("Stopped");
        } else if (this.view === 3) {
            this.blink();
        } else {
            this.slider.value = this.slider.value < 50 ? 100 : 0;
            this.update();
        }
    }

    blink() {
        if (!this.box.isConnected || !this.box.closest("details").open) return;
        this.actual_shown = !this.actual_shown;
        this.update();
    }

    update() {
        const actual = this.frames?.[1];
        const part = Number(this.slider.value);
        const caption = find("figcaption", this.stacked);
        this.stack.style.filter = this.view === 4 ? `brightness(${this.factor.value})` : "";
        for (const frame of this.frames ?? []) {
            if (!frame) continue;
            frame.style.width = this.width * this.fitted + "px";
            frame.style.height = this.height * this.fitted + "px";
            const scale = this.fitted * this.zoom;
            frame.classList.toggle("pixels", scale >= 2);
            find("img", frame).style.transform =
                `translate(${-this.pan[0] * scale}px, ${-this.pan[1] * scale}px) scale(${scale})`;
        }
        if (!actual) return;
        actual.style.clipPath = this.view === 1 ? `inset(0 0 0 ${100 - part}%)` : "";
        actual.style.opacity = this.view === 2 ? part / 100 : 1;
        actual.style.visibility = this.view === 3 && !this.actual_shown ? "hidden" : "";
        caption.textContent = ["", "Expected left, actual right", "Expected below, actual above",
            this.actual_shown ? "Actual" : "Expected", "Difference of the colors"][this.view] ?? "";
    }

    fit() {
        this.fitted = Math.max(1, Math.floor(fit_width / Math.max(this.width, this.height))) ||
            fit_width / this.width;
        if (this.width > fit_width) this.fitted = fit_width / this.width;
        this.zoom = 1;
        this.pan = [0, 0];
        this.update();
    }

    zoom_by(factor, at = [this.width / 2, this.height / 2]) {
        const zoom = Math.min(Math.max(this.zoom * factor, 1), 64);
        this.pan = this.pan.map((pan, i) => {
            const size = i === 0 ? this.width : this.height;
            const moved = at[i] - (at[i] - pan) * this.zoom / zoom;
            return Math.min(Math.max(moved, 0), size - size / zoom);
        });
        this.zoom = zoom;
        this.update();
    }

    // Returns the pixel under the pointer, or null.
    pixel(event) {
        const frame = event.target.closest(".frame");
        if (!frame) return null;
        const box = frame.getBoundingClientRect();
        const scale = this.fitted * this.zoom;
        const x = Math.floor((event.clientX - box.left) / scale + this.pan[0]);
        const y = Math.floor((event.clientY - box.top) / scale + this.pan[1]);
        return x >= 0 && y >= 0 && x < this.width && y < this.height ? [x, y] : null;
    }

    point(event) {
        const pixel = this.pixel(event);
        if (event.buttons === 1 && pixel) {
            const scale = this.fitted * this.zoom;
            this.zoom_by(1);
            this.pan = this.pan.map((pan, i) => {
                const size = i === 0 ? this.width : this.height;
                const moved = pan - (i === 0 ? event.movementX : event.movementY) / scale;
                return Math.min(Math.max(moved, 0), size - size / this.zoom);
            });
            this.update();
        }
        this.values.textContent = pixel ? this.text_at(...pixel) : "";
    }

    wheel(event) {
        const pixel = this.pixel(event);
        if (!pixel || !(event.ctrlKey || this.zoom > 1)) return;
        event.preventDefault();
        this.zoom_by(event.deltaY < 0 ? 1.25 : 0.8, pixel);
    }

    text_at(x, y) {
        this.pixels ??= this.images.slice(0, 2).map((image) => image && pixels_of(image));
        const texels = this.pixels.map((data) =>
            data && [...data.data.slice((y * data.width + x) * 4, (y * data.width + x) * 4 + 3)]);
        let text = `${x}, ${y}`;
        if (texels[0]) text += `   expected ${texels[0].join(" ")}`;
        if (texels[1]) text += `   actual ${texels[1].join(" ")}`;
        if (texels[0] && texels[1] && this.box.dataset.measure === "degrees")
            text += `   ${degrees_between(texels[0], texels[1]).toFixed(2)} degrees`;
        return text;
    }
}

function open_viewer(check) {
    const box = find(".images", check);
    if (!box || viewers.has(check) || !find("img", box)) return;
    viewers.set(check, new Viewer(box));
}

// Small images in the line of a check.
function add_thumbnails(check) {
    const time = find(".time", check);
    for (const image of find_all(".images img", check)) {
        const draw = () => {
            const height = 40;
            const width = Math.round(height * image.naturalWidth / image.naturalHeight);
            const canvas = element("canvas", { width: 2 * width, height: 2 * height });
            canvas.setAttribute("aria-hidden", "true");
            canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
            time.before(canvas);
        };
        if (image.complete && image.naturalWidth) draw();
        else image.addEventListener("load", draw, { once: true });
    }
}

function start() {
    for (const check of checks) {
        add_thumbnails(check);
        check.addEventListener("toggle", () => check.open && open_viewer(check));
        find("summary", check).addEventListener("click", () => make_current(check));
        if (check.open) open_viewer(check);
    }
    read_hash();
    apply_state();
}
if (document.readyState === "complete") start();
else addEventListener("load", start);
