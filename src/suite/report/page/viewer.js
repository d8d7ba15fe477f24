// Three pictures of one shot with one zoom: expected, got, and their difference or the heat map.

const kLargestZoom = 64;

class Viewer {
    constructor() {
        this.panes = [...document.querySelectorAll("#panes figure")].map((figure) => ({
            kind: figure.dataset.pane,
            caption: figure.querySelector("figcaption"),
            canvas: figure.querySelector("canvas"),
            close: figure.querySelector(".close"),
        }));
        this.pictures = {};  // expected, got, heat, difference: canvas or image
        this.loading = true;
        this.pixels = null;
        this.swapped = false;
        this.peeking = false;
        this.heat = false;
        this.factor = 8;
        this.pointer = null;
        this.view = {zoom: 1, x: 0, y: 0, fits: true};
        for (const pane of this.panes) this.listen(pane);
        new ResizeObserver(() => this.resized()).observe(document.getElementById("panes"));
    }

    // Shows the pictures of a shot as they arrive.
    async show(shot) {
        this.shot = shot;
        this.loading = true;
        this.pixels = null;
        this.pictures = {};
        this.place = null;  // where the pictures differ most, if that is a small part of them
        this.pointer = null;
        this.heat = false;
        this.view = {...this.view, fits: true};
        this.draw();
        const [pixels, ...images] = await Promise.all(
            [pixelsOf(shot.pixels), ...["expected", "got", "difference"].map((kind) => loadImage(shot[kind]))]);
        if (this.shot !== shot) return;
        this.loading = false;
        this.pixels = pixels;
        [this.pictures.expected, this.pictures.got, this.pictures.heat] = images;
        for (const kind of ["expected", "got"])
            if (pixels?.[kind]) this.pictures[kind] = toCanvas(pixels[kind]);
        if (!this.canSubtract() && this.pictures.heat) this.heat = true;
        this.subtract();
        this.place = pixels?.expected && pixels?.got ? placeOfDifference(pixels.expected, pixels.got) : null;
        this.resized();
        document.getElementById("panes").dataset.shown = shot.id;
    }

    canSubtract() { return Boolean(this.pictures.expected && this.pictures.got); }
    showsHeat() { return this.heat && Boolean(this.pictures.heat); }

    subtract() {
        const {expected, got} = this.pictures;
        if (this.pixels?.expected && this.pixels?.got)
            this.pictures.difference = differenceCanvas(this.pixels.expected, this.pixels.got, this.factor);
        else if (expected && got)
            this.pictures.difference = blendedDifference(expected, got, this.factor);
    }

    size() {
        const all = Object.values(this.pictures).filter(Boolean);
        return {width: Math.max(1, ...all.map((each) => each.width)),
                height: Math.max(1, ...all.map((each) => each.height))};
    }

    setFactor(factor) {
        this.factor = factor;
        if (!this.shot) return;
        this.subtract();
        this.draw();
    }
    setSwapped(swapped) { this.swapped = swapped; this.draw(); }
    peek(on) { this.peeking = on; this.draw(); }
    toggleHeat() {
        if (!this.pictures.heat) return;
        this.heat = !this.heat;
        this.draw();
    }
    alone(number) {
        const panes = document.getElementById("panes");
        if (number && panes.dataset.alone !== String(number)) panes.dataset.alone = number;
        else delete panes.dataset.alone;
        this.resized();
    }

    // Panes have the proportions of the picture if the window is high enough. Canvases have one pixel per screen
    // pixel.
    resized() {
        const ratio = window.devicePixelRatio || 1, {width: across, height: down} = this.size();
        for (const {canvas} of this.panes) {
            const high = Math.min(0.62 * window.innerHeight, Math.max(96, canvas.clientWidth * down / across));
            if (canvas.clientWidth) canvas.style.height = `${Math.round(high) + 2}px`;
            const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
            if (width && (canvas.width !== width || canvas.height !== height))
                Object.assign(canvas, {width, height});
        }
        for (const {canvas, close} of this.panes) {
            close.hidden = !this.place;
            close.style.height = canvas.style.height;
            Object.assign(close, {width: canvas.width, height: canvas.height});
        }
        if (this.view.fits) this.fit();
        else this.draw();
    }
    reference() { return this.panes.find(({canvas}) => canvas.clientWidth > 0)?.canvas ?? this.panes[0].canvas; }
    fit() {
        const {width, height} = this.size(), canvas = this.reference();
        const most = Math.min(canvas.width / width, canvas.height / height);
        const zoom = most >= 1 ? Math.min(Math.floor(most), kLargestZoom) : most;
        this.view = {zoom, x: Math.round((canvas.width - width * zoom) / 2),
                     y: Math.round((canvas.height - height * zoom) / 2), fits: true};
        this.draw();
    }
    zoomToDifference() {
        if (!this.place) return;
        this.view = {...viewOf(this.place, this.reference()), fits: false};
        this.draw();
    }
    zoomBy(factor, x, y) {
        const canvas = this.reference(), {zoom} = this.view;
        x ??= canvas.width / 2;
        y ??= canvas.height / 2;
        const next = Math.min(kLargestZoom, Math.max(1 / 32, zoom * factor));
        this.view = {zoom: next, x: x - (x - this.view.x) * next / zoom, y: y - (y - this.view.y) * next / zoom, fits: false};
        this.draw();
    }

    listen({canvas}) {
        const ratio = () => canvas.width / canvas.clientWidth;
        let last = null;
        canvas.addEventListener("wheel", (event) => {
            event.preventDefault();
            this.zoomBy(2 ** (-Math.sign(event.deltaY) / 2), event.offsetX * ratio(), event.offsetY * ratio());
        }, {passive: false});
        canvas.addEventListener("pointerdown", (event) => {
            last = event;
            canvas.setPointerCapture(event.pointerId);
        });
        canvas.addEventListener("pointerup", () => { last = null; });
        canvas.addEventListener("pointermove", (event) => {
            if (last && event.buttons) {
                this.view.x += (event.clientX - last.clientX) * ratio();
                this.view.y += (event.clientY - last.clientY) * ratio();
                this.view.fits = false;
                last = event;
            }
            const {zoom, x, y} = this.view;
            this.pointer = {x: Math.floor((event.offsetX * ratio() - x) / zoom),
                            y: Math.floor((event.offsetY * ratio() - y) / zoom)};
            this.draw();
        });
        canvas.addEventListener("pointerleave", () => { this.pointer = null; this.draw(); });
        canvas.addEventListener("dblclick", () => this.fit());
    }

    // The picture that a pane shows.
    content(kind) {
        const swaps = this.swapped !== this.peeking;
        const names = {expected: swaps ? "got" : "expected", got: swaps ? "expected" : "got",
                       difference: this.showsHeat() ? "heat" : "difference"};
        return names[kind];
    }

    draw() {
        for (const {kind, caption, canvas, close} of this.panes) {
            const name = this.content(kind);
            const picture = this.pictures[name];
            const context = drawn(canvas, picture, this.view);
            if (this.place) {
                drawn(close, picture, viewOf(this.place, close));
                frame(context, this.place, this.view);
            }
            const title = {heat: "heat map", difference: `difference × ${this.factor}`, ...this.shot?.titles}[name] ?? name;
            caption.textContent = picture ? `${title}, ${picture.width} × ${picture.height}`
                : this.loading ? title : `${title}: no picture`;
            this.drawPointer(context);
        }
        this.drawTools();
        this.drawValues();
    }
    drawPointer(context) {
        if (!this.pointer) return;
        const {zoom, x, y} = this.view;
        const side = Math.max(zoom, 5);
        context.setTransform(1, 0, 0, 1, 0, 0);
        const left = x + (this.pointer.x + 0.5) * zoom - side / 2, top = y + (this.pointer.y + 0.5) * zoom - side / 2;
        context.strokeStyle = "#000";
        context.strokeRect(left - 1.5, top - 1.5, side + 3, side + 3);
        context.strokeStyle = "#fff";
        context.strokeRect(left - 0.5, top - 0.5, side + 1, side + 1);
    }
    drawTools() {
        document.getElementById("place").hidden = !this.place;
        document.getElementById("swap").setAttribute("aria-pressed", String(this.swapped));
        const mode = document.getElementById("mode");
        mode.hidden = !this.pictures.heat || !this.canSubtract();
        mode.setAttribute("aria-pressed", String(this.showsHeat()));
        document.getElementById("factorLabel").hidden = this.showsHeat() || !this.canSubtract();
        document.getElementById("zoomText").textContent = this.loading ? "" : `${Number((this.view.zoom * 100).toPrecision(3))} %`;
    }
    drawValues() {
        const line = document.getElementById("values");
        if (!this.pixels) {
            line.textContent = this.shot && !this.shot.pixels ? "The values of pixels are kept for pictures that need a look." : "";
            return;
        }
        if (!this.pointer) {
            line.textContent = "Point at a pixel to read its values.";
            return;
        }
        const {x, y} = this.pointer, {expected, got} = this.pixels;
        const a = valuesAt(expected, x, y), b = valuesAt(got, x, y);
        const isFloat = (expected ?? got)?.type === "f32";
        const comparable = a && b && expected.type === got.type;
        const full = expected?.components === 4 || got?.components === 4 ? 4 : 3;
        const opaque = (values, pixels) => values && values.length < full ? [...values, pixels.full] : values;
        const first = opaque(a, expected), second = opaque(b, got);
        const difference = comparable ? first.map((each, i) => second[i] - each) : null;
        line.replaceChildren(...[["pixel", `${x} ${y}`], ["expected", valueText(first, isFloat)], ["got", valueText(second, isFloat)],
                                 ["difference", valueText(difference, isFloat)]].flatMap(([title, value]) => {
            const text = document.createElement("b");
            text.textContent = value;
            text.dataset.value = title;
            return [`${title} `, text, "   "];
        }));
    }
}

// Clears a canvas and draws a picture on it: enlarged pixels are squares.
function drawn(canvas, picture, {zoom, x, y}) {
    const context = canvas.getContext("2d");
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    if (!picture) return context;
    context.setTransform(zoom, 0, 0, zoom, x, y);
    context.imageSmoothingEnabled = zoom < 1;
    context.drawImage(picture, 0, 0);
    return context;
}

// The view of a canvas in which a part of the picture fills it.
function viewOf({left, top, side}, {width, height}) {
    const most = Math.min(width, height) / side, zoom = Math.min(most >= 1 ? Math.floor(most) : most, kLargestZoom);
    return {zoom, x: Math.round(width / 2 - (left + side / 2) * zoom), y: Math.round(height / 2 - (top + side / 2) * zoom)};
}

function frame(context, {left, top, side}, {zoom, x, y}) {
    context.setTransform(1, 0, 0, 1, 0, 0);
    for (const [color, more] of [["#000", 1.5], ["#fff", .5]]) {
        context.strokeStyle = color;
        context.strokeRect(x + left * zoom - more, y + top * zoom - more, side * zoom + 2 * more, side * zoom + 2 * more);
    }
}

function loadImage(source) {
    if (!source) return Promise.resolve(null);
    return new Promise((resolve) => {
        const image = new Image();
        image.onload = () => resolve(image);
        image.onerror = () => resolve(null);
        image.src = source;
    });
}

// The difference of pictures whose pixels may not be read, by blending.
function blendedDifference(a, b, factor) {
    const canvas = newCanvas(Math.max(a.width, b.width), Math.max(a.height, b.height));
    const context = canvas.getContext("2d");
    context.drawImage(a, 0, 0);
    context.globalCompositeOperation = "difference";
    context.drawImage(b, 0, 0);
    const brighter = newCanvas(canvas.width, canvas.height);
    const target = brighter.getContext("2d");
    target.filter = `brightness(${factor})`;
    target.drawImage(canvas, 0, 0);
    return brighter;
}
