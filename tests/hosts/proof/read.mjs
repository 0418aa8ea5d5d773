// node read.mjs CHROMIUM PAGE JOBS: calls run() of the page, in this folder, with the arguments of
// each job of a JSON list, and prints the results as JSON.
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import puppeteer from 'puppeteer-core';

const [, , chromium, document, jobs] = process.argv;
const types = {'.html': 'text/html', '.js': 'text/javascript'};
const server = http.createServer((request, answer) => {
  const file = path.join(process.cwd(), path.normalize(new URL(request.url, 'http://x').pathname));
  if (!fs.existsSync(file)) return answer.writeHead(404).end();
  answer.writeHead(200, {'Content-Type': types[path.extname(file)] ?? 'application/octet-stream'});
  fs.createReadStream(file).pipe(answer);
}).listen(0, '127.0.0.1');
const browser = await puppeteer.launch({
  executablePath: chromium,
  args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
    '--ignore-gpu-blocklist', '--enable-unsafe-webgpu', '--use-webgpu-adapter=swiftshader',
    '--enable-features=Vulkan', '--use-vulkan=swiftshader'],
});
const page = await browser.newPage();
page.on('pageerror', (error) => console.error(error.message));
page.on('console', (message) => { if (message.type() === 'error') console.error(message.text()); });
await page.goto(`http://127.0.0.1:${server.address().port}/${document}`);
await page.waitForFunction('window.ready');
const results = [];
for (const job of JSON.parse(fs.readFileSync(jobs, 'utf8')))
  results.push(await page.evaluate((words) => window.run(...words), job));
await browser.close();
server.close();
console.log(JSON.stringify(results));
