// The view: the mouse and fingers over the picture, the projection, and the camera.

/** @typedef {import("./types.js").View} View */
/** @typedef {import("./matrices.js").Drag} Drag */
import { iconButton, make, menu } from "./dom.js";
import { dragged, draggedTexture, identity, isIdentity, product } from "./matrices.js";

const kWheelPixels = 20;  // of a drag, for one notch
/** @typedef {"eye" | "scene" | "texture"} Mode what the mouse moves */

/** @returns {View} as the scene has it */
const ownView = () => ({ scene: identity(), eye: identity(), texture: identity(), projection: "scene" });

export class ViewControl {
    /**
     * @param {() => void} changed
     * @param {(change: object) => void} tell the runtime
     */
    constructor(changed, tell) {
        this.changed = changed;
        this.tell = tell;
        /** @type {Mode} */
        this.mode = "eye";
        this.camera = "";
        /** @type {string[]} */
        this.cameras = [];
        /** @type {[number, number, number]} */
        this.mouse = [0.5, 0.5, 0];
        // Of the last frame: the camera's view without these transforms, and its projection.
        this.around = { before: identity(), projection: identity() };
        /** @type {Map<number, PointerEvent>} */
        this.pointers = new Map();
        this.isTurning = false;  // the one finger on the picture
        this.lastNotch = { size: 0, time: 0, shrinking: 0 };
        this.view = ownView();
        this.cameraMenu = menu("Camera (C)", [["", "own camera"]], (value) => this.tell({ camera: value }));
        this.projectionMenu = menu("Projection (P)", [["scene", "own projection"], ["orthographic", "orthographic"], ["perspective", "perspective"]], (value) => {
            this.view.projection = /** @type {View["projection"]} */ (value);
            this.changed();
        });
        this.modeMenu = menu("What mouse, fingers and arrow keys move (1, 2, 4)", [["eye", "move eye"], ["scene", "move scene"], ["texture", "move textures"]],
            (value) => this.setMode(/** @type {Mode} */ (value)));
        this.resetButton = iconButton("home", "Reset the view (R)", () => this.reset());
        this.isFixed = false;  // as in a film
        this.element = make("span", { class: "view", role: "group", "aria-label": "View" }, this.modeMenu, this.projectionMenu, this.cameraMenu, this.resetButton);
    }

    /** Nothing turns the scene. */
    fix() {
        this.isFixed = this.element.hidden = true;
    }

    /**
     * @param {string[]} cameras
     * @param {string} camera
     */
    fill(cameras, camera) {
        this.cameras = cameras;
        this.camera = camera;
        this.cameraMenu.hidden = cameras.length < 2;
        this.cameraMenu.replaceChildren(...["", ...cameras].map((each) => make("option", { value: each, text: each || "own camera" })));
    }

    show() {
        this.cameraMenu.value = this.camera;
        this.projectionMenu.value = this.view.projection;
        this.modeMenu.value = this.mode;
        this.resetButton.disabled = !this.isChanged;
    }

    get isChanged() {
        return this.view.projection !== "scene" || this.camera !== "" ||
            ![this.view.scene, this.view.eye, this.view.texture].every(isIdentity);
    }

    reset() {
        this.view = ownView();
        this.tell({ camera: "" });
    }

    /** @param {Mode} mode */
    setMode(mode) {
        this.mode = mode;
        this.show();
    }

    /** The next of: as in the scene, without perspective, with perspective. */
    nextProjection() {
        /** @type {View["projection"][]} */
        const round = ["scene", "orthographic", "perspective"];
        this.view.projection = round[(round.indexOf(this.view.projection) + 1) % round.length];
        this.changed();
    }

    nextCamera() {
        const round = ["", ...this.cameras];
        this.tell({ camera: round[(round.indexOf(this.camera) + 1) % round.length] });
    }

    /** @param {Drag} drag */
    drag(drag) {
        const { view } = this, { before, projection } = this.around;
        if (this.mode === "texture") view.texture = draggedTexture(view.texture, drag);
        else if (this.mode === "eye") view.eye = dragged(view.eye, drag, before, product(projection, view.scene));
        else view.scene = dragged(view.scene, drag, product(view.eye, before), projection);
        this.changed();
    }

    /** @param {HTMLCanvasElement} canvas */
    listen(canvas) {
        if (this.isFixed) return;
        // Two fingers never scroll the page.
        canvas.addEventListener("touchstart", (event) => event.touches.length > 1 && event.cancelable && event.preventDefault(), { passive: false });
        canvas.addEventListener("pointerdown", (event) => {
            canvas.focus({ preventScroll: true });
            canvas.setPointerCapture(event.pointerId);
            this.isTurning = event.pointerType !== "touch" || document.fullscreenElement !== null;
            this.pointers.set(event.pointerId, event);
            this.follow(canvas, event);
        });
        canvas.addEventListener("pointermove", (event) => {
            for (const each of event.getCoalescedEvents?.() ?? [event]) this.move(canvas, each);
            this.follow(canvas, event);
        });
        for (const end of /** @type {const} */ (["pointerup", "pointercancel"]))
            canvas.addEventListener(end, (event) => {
                this.pointers.delete(event.pointerId);
                this.follow(canvas, event);
            });
        canvas.addEventListener("contextmenu", (event) => event.preventDefault());
        canvas.addEventListener("wheel", (event) => this.wheel(canvas, event), { passive: false });
    }

    /**
     * @param {HTMLCanvasElement} canvas
     * @param {PointerEvent} event
     */
    move(canvas, event) {
        const before = this.pointers.get(event.pointerId);
        if (!before) return;
        const x = event.clientX - before.clientX, y = before.clientY - event.clientY;
        const { width, height } = canvas.getBoundingClientRect();
        const other = [...this.pointers.values()].find((each) => each.pointerId !== event.pointerId);
        // A finger that begins upwards or downwards scrolls the page (see live.css).
        this.isTurning ||= other !== undefined || Math.abs(x) > Math.abs(y);
        if (!this.isTurning || (x === 0 && y === 0)) return;
        this.pointers.set(event.pointerId, event);
        if (other) {
            // Two fingers: what they have in common moves, and their distance scales.
            const distance = (/** @type {PointerEvent} */ each) => Math.hypot(each.clientX - other.clientX, each.clientY - other.clientY);
            const growth = Math.max(distance(event), 1) / Math.max(distance(before), 1);
            this.drag({ gesture: "pan", x: x / 2, y: y / 2, width, height });
            this.drag({ gesture: "scale", x: 0, y: Math.log10(growth) * height, width, height });
            return;
        }
        const gesture = (event.buttons & 4) !== 0 || event.ctrlKey ? "scale" : (event.buttons & 2) !== 0 || event.shiftKey ? "pan" : "rotate";
        this.drag({ gesture, x, y, width, height });
    }

    /**
     * Where the mouse is for a scene that reads it: 0 to 1 from the lower left corner.
     * @param {HTMLCanvasElement} canvas
     * @param {PointerEvent} event
     */
    follow(canvas, event) {
        const box = canvas.getBoundingClientRect();
        const inside = (/** @type {number} */ value) => Math.min(Math.max(value, 0), 1);
        this.mouse = [inside((event.clientX - box.left) / box.width), inside(1 - (event.clientY - box.top) / box.height), event.buttons & 1];
        this.changed();
    }

    /**
     * The wheel scales where the picture has been clicked; elsewhere it scrolls the page.
     * @param {HTMLCanvasElement} canvas
     * @param {WheelEvent} event
     */
    wheel(canvas, event) {
        if (document.activeElement !== canvas && !event.ctrlKey && !document.fullscreenElement) return;
        event.preventDefault();
        const notches = -event.deltaY / [100, 3, 1][event.deltaMode], last = this.lastNotch;
        // What a touchpad goes on scrolling after the fingers have left it, with smaller and smaller steps, does not count.
        const continues = event.timeStamp - last.time < 120 && notches > 0 === last.size > 0;
        const shrinks = continues && Math.abs(notches) < Math.abs(last.size) && !Number.isInteger(notches);
        this.lastNotch = { size: notches, time: event.timeStamp, shrinking: shrinks ? last.shrinking + 1 : 0 };
        const { width, height } = canvas.getBoundingClientRect();
        if (notches !== 0 && this.lastNotch.shrinking < 3)
            this.drag({ gesture: "scale", x: 0, y: Math.min(Math.max(notches, -2), 2) * kWheelPixels, width, height });
    }
}
