// A checkered floor in the world.

uniform float uTiles;  // tiles along 256 units
uniform vec3 uSun, cameraPosition;

/// Dark and light tiles: the mean over a pixel, so that edges are smooth, and distant tiles fade.
vec3 tileColor(vec2 place) {
    vec2 p = place * uTiles / 256., size = fwidth(p) + 1e-6;
    // The integral of a stripe, 1 or -1, from one side of the pixel to the other.
    vec2 stripe = 2. * (abs(fract((p + .5 * size) / 2.) - .5) - abs(fract((p - .5 * size) / 2.) - .5)) / size;
    float light = .5 - .5 * stripe.x * stripe.y;
    return mix(vec3(.02, .10, .42), vec3(.62, .74, .95), light);
}

vec3 litFloor(vec3 color, vec3 normal, vec3 place) {
    vec3 toSun = normalize(uSun), toEye = normalize(cameraPosition - place);
    float specular = pow(max(dot(normal, normalize(toSun + toEye)), 0.), 60.);
    return (.35 + .65 * max(dot(normal, toSun), 0.)) * color + .3 * specular;
}
