// Three surfaces z = f(x, y) on the square -2..2 with their slopes: height and both derivatives.
vec3 surface(int kind, vec2 p, float height) {
    if (kind == 0)      // egg box
        return height * vec3(sin(3. * p.x) * sin(3. * p.y), 3. * cos(3. * p.x) * sin(3. * p.y), 3. * sin(3. * p.x) * cos(3. * p.y));
    if (kind == 1)      // saddle for a monkey: x^3 - 3 x y^2
        return height * .25 * vec3(p.x * p.x * p.x - 3. * p.x * p.y * p.y, 3. * (p.x * p.x - p.y * p.y), -6. * p.x * p.y);
    // A wave over a bell: cos(4 r^2) exp(-r^2)
    float r2 = dot(p, p), bell = exp(-r2);
    float byR2 = -(4. * sin(4. * r2) + cos(4. * r2)) * bell;
    return height * 2. * vec3(cos(4. * r2) * bell, 2. * byR2 * p);
}
