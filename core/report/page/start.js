// Bodies of checks, and small images in the lines of those in view.

function open_body(check) {
    fill(check);
    const box = find(".images", check);
    if (!find(".choose", check)) add_choice(check);
    if (box && find("img", box) && !viewers.has(check)) viewers.set(check, new Viewer(box));
}

async function add_thumbnails(check) {
    fill(check);
    const time = find(".time", check);
    // A viewer moves the images.
    const images = viewers.get(check)?.images ?? find_all(".images img", check);
    for (const image of images.filter(Boolean)) {
        try {
            await image.decode();
        } catch {
            continue;
        }
        const height = 40;
        const width = Math.round(height * image.naturalWidth / image.naturalHeight);
        const canvas = element("canvas", { width: 2 * width, height: 2 * height });
        canvas.setAttribute("aria-hidden", "true");
        canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
        time.before(canvas);
    }
}

const in_view = new IntersectionObserver((entries) => {
    for (const entry of entries)
        if (entry.isIntersecting) {
            in_view.unobserve(entry.target);
            add_thumbnails(entry.target);
        }
}, { rootMargin: "300px" });

function start() {
    for (const check of checks) in_view.observe(check);
    // Events of <details> do not bubble, but they are captured.
    list.addEventListener("toggle", (event) => {
        if (event.target.open && event.target.matches("details.check")) open_body(event.target);
    }, true);
    list.addEventListener("click", (event) => {
        const summary = event.target.closest("details.check > summary");
        if (summary) make_current(summary.parentNode);
    });
    for (const check of checks) if (check.open) open_body(check);
    read_hash();
    apply_state();
}
start();
