// The time of a scene: it plays, pauses, steps and runs at any speed.

import { iconButton, make, rename } from "./dom.js";

/** @typedef {import("./types.js").Span} Span */

const kFrameSeconds = 1 / 30;
const kMostSeconds = 0.25;  // that one frame may take of the time

export class Clock {
    /**
     * @param {() => void} changed
     * @param {() => void} restart what lasts begins anew
     */
    constructor(changed, restart) {
        this.changed = changed;
        this.seconds = 0;
        this.speed = 1;
        this.isPlaying = !matchMedia("(prefers-reduced-motion: reduce)").matches;
        this.stepRate = 0;
        /** @type {Span | undefined} of a film, which begins anew after its end */
        this.span = undefined;
        /** @type {number | undefined} of the last frame, in milliseconds */
        this.last = undefined;
        this.playButton = iconButton("pause", "Pause (Space)", () => this.play(!this.isPlaying));
        this.stepButton = iconButton("step", "Next step (B)", () => this.nextStep());
        this.restartButton = iconButton("restart", "Restart at 0 seconds", restart);
        this.field = make("input", { type: "number", class: "seconds", min: 0, step: "any", "aria-label": "Seconds", title: "Seconds",
            change: ({ target }) => this.goTo(target.valueAsNumber) });
        this.speedField = make("input", { type: "number", class: "speed", value: 1, step: 0.25, "aria-label": "Speed", title: "Speed",
            change: ({ target }) => this.setSpeed(target.valueAsNumber) });
        this.thumb = make("input", { type: "range", class: "scrub", min: 0, step: 1, "aria-label": "Time", title: "Time",
            input: ({ target }) => this.span && this.goTo(this.span.begin + target.valueAsNumber * this.span.step) });
        this.element = make("span", { class: "time", role: "group", "aria-label": "Time" },
            this.playButton,
            iconButton("back", "Previous frame (,)", () => this.step(-1)),
            iconButton("forward", "Next frame (.)", () => this.step(1)),
            this.stepButton,
            this.restartButton,
            this.thumb,
            make("label", {}, this.field, " s"),
            make("label", {}, "\u00d7 ", this.speedField));
    }

    /** @param {{ animated: boolean, hasSteps: boolean, stepRate?: number, span?: Span }} scene */
    fill(scene) {
        this.span = scene.span;
        this.thumb.hidden = !scene.span;
        rename(this.restartButton, "restart", `Restart at ${scene.span?.begin ?? 0} seconds`);
        this.thumb.max = String((scene.span?.count ?? 1) - 1);
        this.stepRate = scene.stepRate ?? 0;
        this.element.hidden = !scene.animated && !scene.hasSteps;
        this.stepButton.hidden = !scene.hasSteps || !(this.stepRate > 0);
    }

    show() {
        rename(this.playButton, this.isPlaying ? "pause" : "play", this.isPlaying ? "Pause (Space)" : "Play (Space)");
        if (document.activeElement !== this.field) this.field.value = this.at(this.seconds).toFixed(2);
        if (this.span) this.thumb.valueAsNumber = Math.round((this.at(this.seconds) - this.span.begin) / this.span.step);
        if (document.activeElement !== this.speedField) this.speedField.value = String(this.speed);
    }

    /**
     * The time of the picture at that time.
     * @param {number} seconds
     */
    at(seconds) {
        if (!this.span) return Math.max(0, seconds);
        const { begin, step, count } = this.span, frame = Math.floor((seconds - begin) / step + 1e-6);
        return begin + Math.min(Math.max(frame || 0, 0), count - 1) * step;
    }

    /** @param {boolean} on */
    play(on) {
        this.isPlaying = on;
        if (!on) this.seconds = this.at(this.seconds);
        this.last = undefined;
        this.changed();
    }

    /** @param {number} seconds */
    goTo(seconds) {
        if (Number.isFinite(seconds)) this.seconds = this.at(seconds);
        this.play(false);
    }

    /** @param {number} speed */
    setSpeed(speed) {
        if (Number.isFinite(speed)) this.speed = Math.min(Math.max(speed, -1000), 1000);
        this.changed();
    }

    /** @param {number} frames */
    step(frames) {
        this.goTo(this.seconds + frames * (this.span ? this.span.step * Math.sign(this.speed) : kFrameSeconds * this.speed));
    }

    nextStep() {
        if (this.stepRate > 0) this.goTo((Math.floor(this.seconds * this.stepRate + 1e-6) + 1) / this.stepRate);
    }

    /** The runtime has begun anew. */
    restart() {
        this.seconds = this.span?.begin ?? 0;
        this.last = undefined;
        this.changed();
    }

    /**
     * Seconds of real time since the last frame; none after a pause.
     * @param {number} milliseconds
     */
    secondsSince(milliseconds) {
        return this.last === undefined ? 0 : Math.min((milliseconds - this.last) / 1000, kMostSeconds);
    }

    /**
     * Reports the time of a frame. The first one after a pause has the time of the pause.
     * @param {number} milliseconds
     */
    advance(milliseconds) {
        if (this.isPlaying && !this.element.hidden) {
            const seconds = this.seconds + this.secondsSince(milliseconds) * this.speed;
            if (this.span) {
                const { begin, step, count } = this.span, length = step * count, passed = (seconds - begin) % length;
                this.seconds = begin + (passed < 0 ? passed + length : passed);
            } else this.seconds = Math.max(0, seconds);
        }
        this.last = milliseconds;
    }
}
