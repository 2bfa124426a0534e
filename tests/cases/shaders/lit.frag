#version 330 compatibility
in vec3 vNormal, vPosition;
in vec4 vColor;

void main() {
    vec3 n = normalize(vNormal), light = normalize(vec3(2., 3., 4.) - vPosition);
    float diffuse = max(0., dot(n, light));
    float shine = pow(max(0., dot(reflect(-light, n), normalize(-vPosition))), 30.);
    gl_FragColor = vec4(vColor.rgb * (.25 + .75 * diffuse) + .3 * shine, vColor.a);
}
