// A checkered floor in the world.

uniform float uTiles;  // tiles along 256 units
uniform vec3 uSun, cameraPosition;

/// Dark and light tiles; they fade to their mean where they are smaller than a pixel.
vec3 tileColor(vec2 place) {
    vec2 p = place * uTiles / 256.;
    vec2 cell = floor(p);
    float light = mod(cell.x + cell.y, 2.);
    vec2 size = fwidth(p);
    light = mix(light, .5, smoothstep(.4, 1.2, max(size.x, size.y)));
    return mix(vec3(.02, .10, .42), vec3(.62, .74, .95), light);
}

vec3 litFloor(vec3 color, vec3 normal, vec3 place) {
    vec3 toSun = normalize(uSun), toEye = normalize(cameraPosition - place);
    float specular = pow(max(dot(normal, normalize(toSun + toEye)), 0.), 60.);
    return (.35 + .65 * max(dot(normal, toSun), 0.)) * color + .3 * specular;
}
