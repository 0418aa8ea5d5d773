#include "hosts/browser.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "base/text.h"
#include "hosts/pass.h"
#include "image/stored.h"

namespace wrinkle::test {
namespace {

// Runs after the page is loaded; `mips` and `jobs` are defined before it.
constexpr const char* script = R"js(
const size = 64, lines = [];
const canvas = document.createElement('canvas');
canvas.width = canvas.height = size;
const gl = canvas.getContext('webgl2', {antialias: false, preserveDrawingBuffer: true});
function stage(program, kind, text) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
        throw gl.getShaderInfoLog(shader) || 'no log';
    gl.attachShader(program, shader);
}
function link(job) {
    const program = gl.createProgram();
    stage(program, gl.VERTEX_SHADER, job.vertex);
    stage(program, gl.FRAGMENT_SHADER, job.fragment);
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw gl.getProgramInfoLog(program);
    return program;
}
function draw(job, program) {
    const wraps = {repeat: gl.REPEAT, clamp: gl.CLAMP_TO_EDGE, mirror: gl.MIRRORED_REPEAT};
    gl.useProgram(program);
    job.samplers.forEach((sampler, unit) => {
        const lookup = gl.createSampler(), nearest = sampler.filter === 'nearest';
        gl.samplerParameteri(lookup, gl.TEXTURE_WRAP_S, wraps[sampler.wrap]);
        gl.samplerParameteri(lookup, gl.TEXTURE_WRAP_T, wraps[sampler.wrap]);
        gl.samplerParameteri(lookup, gl.TEXTURE_MAG_FILTER, nearest ? gl.NEAREST : gl.LINEAR);
        gl.samplerParameteri(lookup, gl.TEXTURE_MIN_FILTER,
            nearest ? gl.NEAREST_MIPMAP_NEAREST : gl.LINEAR_MIPMAP_LINEAR);
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.bindSampler(unit, lookup);
        gl.uniform1i(gl.getUniformLocation(program, sampler.name), unit);
    });
    gl.viewport(0, 0, size, size);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const pixels = new Uint8Array(size * size * 4);
    gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    const error = gl.getError();
    if (error) throw 'GL error ' + error;
    return Array.from(pixels, byte => byte.toString(16).padStart(2, '0')).join('');
}
let texture = null;
if (gl) {
    texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    mips.forEach((halves, level) => gl.texImage2D(gl.TEXTURE_2D, level, gl.RGBA16F, 64 >> level,
        64 >> level, 0, gl.RGBA, gl.HALF_FLOAT, new Uint16Array(halves)));
    lines.push('webgl2 ' + gl.getParameter(gl.VERSION));
    for (const job of jobs.filter(job => !job.webgpu)) {
        try {
            const program = link(job);
            lines.push('fine ' + job.name + ' ' + (job.draw ? draw(job, program) : ''));
            gl.deleteProgram(program);
        } catch (problem) {
            lines.push('bad ' + job.name + ' ' + String(problem).replace(/[\n\0<>&]/g, ' '));
        }
    }
}
async function reject_errors(module) {
    const info = await module.getCompilationInfo();
    const errors = info.messages.filter(message => message.type === 'error');
    if (errors.length) throw errors.map(error => error.lineNum + ': ' + error.message).join('; ');
}
function image_of(device) {
    const image = device.createTexture({size: [64, 64], format: 'rgba16float',
        mipLevelCount: mips.length,
        usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST});
    mips.forEach((halves, level) => device.queue.writeTexture({texture: image, mipLevel: level},
        new Uint16Array(halves), {bytesPerRow: (64 >> level) * 8}, [64 >> level, 64 >> level]));
    return image;
}
function bindings(device, job, pipeline, image) {
    const wraps = {repeat: 'repeat', clamp: 'clamp-to-edge', mirror: 'mirror-repeat'};
    const entries = [];
    for (const sampler of job.samplers) {
        const wrap = wraps[sampler.wrap], filter = sampler.filter;
        entries.push({binding: sampler.binding, resource: image.createView()},
            {binding: sampler.sampler_binding, resource: device.createSampler({
                addressModeU: wrap, addressModeV: wrap, magFilter: filter, minFilter: filter,
                mipmapFilter: filter})});
    }
    if (job.block >= 0)
        entries.push({binding: job.block, resource: {buffer: device.createBuffer(
            {size: 256, usage: GPUBufferUsage.UNIFORM})}});
    return device.createBindGroup({layout: pipeline.getBindGroupLayout(0), entries});
}
async function draw_webgpu(device, image, job) {
    const module = device.createShaderModule({code: job.fragment});
    await reject_errors(module);
    if (!job.draw) {
        const vertex = device.createShaderModule({code: job.vertex});
        await reject_errors(vertex);
        return '';
    }
    const target = device.createTexture({size: [size, size], format: 'rgba8unorm',
        usage: GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC});
    const pipeline = device.createRenderPipeline({layout: 'auto',
        vertex: {module, entryPoint: 'pass_vertex'},
        fragment: {module, entryPoint: 'pass_fragment', targets: [{format: 'rgba8unorm'}]}});
    const buffer = device.createBuffer({size: size * size * 4,
        usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ});
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginRenderPass({colorAttachments: [{view: target.createView(),
        loadOp: 'clear', storeOp: 'store'}]});
    pass.setPipeline(pipeline);
    if (job.samplers.length || job.block >= 0) pass.setBindGroup(0, bindings(device, job, pipeline, image));
    pass.draw(3);
    pass.end();
    encoder.copyTextureToBuffer({texture: target}, {buffer, bytesPerRow: size * 4}, [size, size]);
    device.queue.submit([encoder.finish()]);
    await buffer.mapAsync(GPUMapMode.READ);
    return Array.from(new Uint8Array(buffer.getMappedRange()),
        byte => byte.toString(16).padStart(2, '0')).join('');
}
async function run_webgpu() {
    const adapter = navigator.gpu && await navigator.gpu.requestAdapter();
    if (!adapter) return;
    const device = await adapter.requestDevice();
    const image = image_of(device);
    lines.push('webgpu');
    for (const job of jobs.filter(job => job.webgpu)) {
        device.pushErrorScope('validation');
        let pixels = '', problem = null;
        try { pixels = await draw_webgpu(device, image, job); } catch (error) { problem = error; }
        const error = await device.popErrorScope();
        problem = problem || (error && error.message);
        lines.push(problem ? 'bad ' + job.name + ' ' + String(problem).replace(/[\n\0<>&]/g, ' ')
                           : 'fine ' + job.name + ' ' + pixels);
    }
}
run_webgpu().catch(error => lines.push('failed ' + error)).then(
    () => fetch('/results', {method: 'POST', body: lines.join('\n') + '\n'}));
)js";

// For the inside of a <script>.
std::string quoted(const std::string& text) {
    std::string result = json_quoted(text);
    for (size_t at = result.find("</"); at != result.npos; at = result.find("</", at))
        result.replace(at, 2, "<\\/");
    return result;
}

std::string picture_text() {
    std::string text = "[";
    for (const Image& level : pass_picture().levels) {
        text += text.size() > 1 ? ",[" : "[";
        for (size_t i = 0; i < level.data.size(); ++i)
            text += (i ? "," : "") + std::to_string(half_from_float(level.data[i]));
        text += "]";
    }
    return text + "]";
}

std::string job_text(const BrowserJob& job) {
    std::string samplers;
    for (const SamplerInfo& sampler : job.samplers)
        samplers += (samplers.empty() ? "" : ",") + std::string("{\"name\":") +
                    quoted(sampler.name) + ",\"wrap\":\"" +
                    std::string(name_of(sampler.options.wrap)) + "\",\"filter\":\"" +
                    std::string(name_of(sampler.options.filter)) +
                    "\",\"binding\":" + std::to_string(sampler.binding.binding) +
                    ",\"sampler_binding\":" + std::to_string(sampler.sampler_binding) + "}";
    return "{\"name\":" + quoted(job.name) + ",\"draw\":" + (job.draw ? "true" : "false") +
           ",\"webgpu\":" + (job.webgpu ? "true" : "false") +
           ",\"block\":" + std::to_string(job.block) + ",\"vertex\":" + quoted(job.vertex) +
           ",\"fragment\":" + quoted(job.fragment) + ",\"samplers\":[" + samplers + "]}";
}

std::string page(const std::vector<BrowserJob>& jobs) {
    std::string text = "<!DOCTYPE html><meta charset=\"utf-8\">\n<script>\n";
    text += "const mips = " + picture_text() + ";\nconst jobs = [\n";
    for (const BrowserJob& job : jobs)
        text += job_text(job) + ",\n";
    return text + "];\n" + script + "</script>\n";
}

std::string output_of(const std::string& command) {
    std::string text;
    FILE* const pipe = popen(command.c_str(), "r");
    if (!pipe) return text;
    char buffer[1 << 16];
    while (const size_t count = std::fread(buffer, 1, sizeof buffer, pipe))
        text.append(buffer, count);
    pclose(pipe);
    return text;
}

std::vector<uint8_t> bytes_from(const std::string& digits) {
    std::vector<uint8_t> bytes;
    for (size_t i = 0; i + 1 < digits.size(); i += 2)
        bytes.push_back(static_cast<uint8_t>(std::stoul(digits.substr(i, 2), nullptr, 16)));
    return bytes;
}

}  // namespace

std::map<std::string, BrowserResult> run_in_browser(const std::vector<BrowserJob>& jobs,
                                                    const std::filesystem::path& folder,
                                                    std::string& why) {
    std::ofstream(folder / "page.html") << page(jobs);
    const char* named = std::getenv("WRINKLE_CHROMIUM");
    const std::string chromium = named ? named : "chromium";
    const std::string text = output_of(
        "timeout 300 python3 " WRINKLE_SOURCE_DIR "/tests/hosts/serve.py " + chromium + " " +
        (folder / "page.html").string() + " " + (folder / "profile").string() +
        " --headless --no-sandbox --disable-quic --no-first-run --disable-background-networking"
        " --disable-component-update --disable-sync --use-angle=swiftshader"
        " --enable-unsafe-swiftshader --ignore-gpu-blocklist --enable-unsafe-webgpu"
        " --use-webgpu-adapter=swiftshader --enable-features=Vulkan 2>" +
        (folder / "log").string());
    std::map<std::string, BrowserResult> results;
    if (text.find("webgl2 WebGL 2.0") == text.npos) {
        why = text.empty() ? "'" + chromium +
                                 "' did not run: install Debian's package chromium, or "
                                 "name the program in WRINKLE_CHROMIUM"
                           : "the browser has no WebGL 2";
        return results;
    }
    if (text.find("\nwebgpu\n") == text.npos) why = "the browser has no WebGPU";
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string verdict, name, rest;
        words >> verdict >> name;
        std::getline(words >> std::ws, rest);
        if (verdict == "fine") results[name] = {"", bytes_from(rest)};
        if (verdict == "bad") results[name] = {rest.empty() ? "no log" : rest, {}};
    }
    return results;
}

}  // namespace wrinkle::test
