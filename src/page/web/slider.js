// Where a slider's thumb stands for a value, and which value a place of the thumb means: as in the window
// (src/view/scene/slider_scale.cpp).

/** A scale of the values that a film has, each as far from the next. */
export class StopScale {
    /** @param {number[]} stops in rising order */
    constructor(stops) {
        this.stops = stops;
        this.minimum = 0;
        this.maximum = Math.max(stops.length - 1, 1);
        this.isInteger = true;  // it counts them
    }

    /** @param {number} value */
    positionOf(value) {
        return this.stops.indexOf(value) / this.maximum;
    }

    /** @param {number} position */
    valueAt(position) {
        return this.stops[Math.min(Math.round(position * this.maximum), this.stops.length - 1)];
    }
}

export class SliderScale {
    /** @param {{ minimum: number, maximum: number, isInteger: boolean }} knob */
    constructor(knob) {
        this.minimum = Math.min(knob.minimum, knob.maximum);
        this.maximum = Math.max(knob.minimum, knob.maximum);
        if (this.minimum === this.maximum) this.maximum += 1;
        this.isInteger = knob.isInteger;
        this.isLogarithmic = this.minimum > 0 && Math.log10(this.maximum / this.minimum) >= 3 - 1e-9;
    }

    /**
     * 0 at the minimum, 1 at the maximum.
     * @param {number} value
     */
    positionOf(value) {
        if (!(value > this.minimum)) return 0;
        if (value >= this.maximum) return 1;
        if (this.isLogarithmic) return Math.log(value / this.minimum) / Math.log(this.maximum / this.minimum);
        return (value / 2 - this.minimum / 2) / (this.maximum / 2 - this.minimum / 2);
    }

    /**
     * The value at that position, rounded to a thousandth of the range.
     * @param {number} position
     */
    valueAt(position) {
        if (this.isInteger) {
            const low = Math.ceil(this.minimum), high = Math.floor(this.maximum);
            const value = Math.round(this.between(position));
            return low > high ? low : Math.min(Math.max(value, low), high) + 0;
        }
        if (position <= 0) return this.minimum;
        if (position >= 1) return this.maximum;
        const value = this.between(position), size = this.isLogarithmic ? value : this.maximum - this.minimum;
        const digits = Math.floor(Math.log10(Math.abs(value))) - Math.floor(Math.log10(size)) + 3;
        const rounded = value === 0 || digits < -1 ? 0 : digits < 0 ? value : digits > 16 ? value : Number(value.toExponential(digits));
        return Math.min(Math.max(rounded, this.minimum), this.maximum) + 0;
    }

    /** @param {number} position */
    between(position) {
        return this.isLogarithmic ? this.minimum * (this.maximum / this.minimum) ** position
            : this.minimum * (1 - position) + this.maximum * position;
    }
}
