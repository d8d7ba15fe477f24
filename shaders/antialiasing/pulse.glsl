// The integral from 0 to x of a train of pulses: 1 in the first part `duty` of every period, 0 in the rest.
float pulseIntegral(float x, float duty) {
    return floor(x) * duty + min(fract(x), duty);
}

// The mean of the pulses over a filter of the width w about x.
float pulseMean(float x, float w, float duty) {
    return (pulseIntegral(x + w / 2., duty) - pulseIntegral(x - w / 2., duty)) / w;
}
