in vec3 N;
in vec2 vST;
uniform sampler2D uTexUnit;
void main() {
    vec3 c = texture(uTexUnit, vST).rgb;
    gl_FragColor = vec4(c * abs(N.z), 1.f);
}
