// Bodies of checks, and small images in the lines of those in view.

const thumbnail_size = 96;

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
        const scale = thumbnail_size / Math.max(image.naturalWidth, image.naturalHeight);
        const [width, height] = [image.naturalWidth, image.naturalHeight].map(
            (size) => Math.max(Math.round(size * scale), 1));
        const canvas = element("canvas",
            { width: width * devicePixelRatio, height: height * devicePixelRatio });
        canvas.style.width = width + "px";
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
        if (event.target.matches("details.numbers")) fill(event.target);
    }, true);
    list.addEventListener("click", (event) => {
        const link = event.target.closest(".points a");
        const linked = link && document.getElementById(link.getAttribute("href").slice(1));
        if (linked) {
            event.preventDefault();
            select(linked);
        }
        const summary = event.target.closest("details.check > summary");
        if (summary) make_current(summary.parentNode);
    });
    for (const check of checks) if (check.open) open_body(check);
    for (const numbers of find_all("details.numbers[open]")) fill(numbers);
    read_hash();
    apply_state();
}
start();
