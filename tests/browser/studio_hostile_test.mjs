// node studio_hostile_test.mjs PXM [few|many] [PART OF A NAME]: what others may do to a studio is refused
// or bounded, and nothing is lost. `many` is the long campaign.
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, readdirSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import http from 'node:http';
import net from 'node:net';
import { basename, dirname, join, resolve } from 'node:path';
import { openPage, settled, startBrowser, startStudio } from './studio.mjs';

const program = resolve(process.argv[2]);
const many = process.argv[3] === 'many';
const only = process.argv[4];
const tetra = readFileSync(new URL('../../scenes/tetra.pxm', import.meta.url), 'utf8');
const secret = 'what nobody may read';
const gigabyte = 2 ** 30;

const fill = folder => {
  writeFileSync(join(folder, 'tetra.pxm'), tetra);
  writeFileSync(join(folder, '<img src=x onerror=window.stolen=1>.pxm'), `# </textarea><script>window.stolen=1</script>\n${tetra}`);
  writeFileSync(`${folder}.secret.pxm`, secret);
  symlinkSync(`${folder}.secret.pxm`, join(folder, 'link.pxm'));
  mkdirSync(join(folder, '.hidden'));
  writeFileSync(join(folder, '.hidden', 'a.pxm'), secret);
};

const { browser, context } = await startBrowser();
const studio = await startStudio(program, fill);
const { port, origin } = new URL(studio.address);
const agent = new http.Agent({ keepAlive: true, maxSockets: 24 });
const memory = () => Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${studio.child.pid}/status`, 'utf8'))[1]) / 1024;  // MB

/// { status, body, fields }
const send = (path, { method = 'GET', headers = {}, body, to = port } = {}) => new Promise((done, failed) => {
  const request = http.request({ port: to, host: '127.0.0.1', path, method, agent, headers: { Host: `127.0.0.1:${to}`, ...headers } }, response => {
    const parts = [];
    response.on('data', part => parts.push(part));
    response.on('end', () => done({ status: response.statusCode, body: Buffer.concat(parts).toString('latin1'), fields: response.headers }));
  });
  request.on('error', failed);
  request.end(body);
});
const cookie = (await send(new URL(studio.address).pathname + new URL(studio.address).search)).fields['set-cookie'][0].split(';')[0];
const known = { Cookie: cookie, 'Content-Type': 'application/json', Origin: origin };
const ask = (path, question) => send(path, { method: 'POST', headers: known, body: typeof question === 'string' ? question : JSON.stringify(question) });
const picture = { view: 'test-picture', name: 'tetra.pxm', text: tetra, columns: 8, rows: 8, samples: 1, machine: '', settings: [] };
let serial = 0;
const pause = time => new Promise(done => setTimeout(done, time));

async function still_works() {
  for (let i = 0; i < 40; ++i) {
    const answer = await ask('/api/picture', { ...picture, serial: ++serial });
    if (answer.status === 200) return assert.ok(answer.body.length > 256);
    assert.equal(answer.status, 429);
    await pause(100);
  }
  assert.fail('it answers nothing any more');
}

const tests = {
  async a_crowd_of_requests_is_refused_and_answered_as_before() {
    const count = many ? 100_000 : 4_000;
    const kinds = [
      [{ headers: {} }, [401, 429]],
      [{ headers: { Cookie: `pxm=${'0'.repeat(32)}` } }, [401, 429]],
      [{ headers: { ...known, Host: 'evil.example' } }, [403, 429]],
      [{ headers: { ...known, Origin: 'http://evil.example' } }, [403, 429]],
      [{ headers: known, method: 'POST', body: '{' }, [200, 429]],
      [{ headers: { ...known, 'Content-Type': 'text/plain' }, method: 'POST', body: '{}' }, [415, 429]],
      [{ headers: known, method: 'DELETE' }, [405, 429]],
      [{ headers: known }, [200, 429]],
    ];
    await still_works();
    const before = memory(), begin = Date.now();
    const statuses = new Map();
    let next = 0;
    const client = async () => {
      while (next < count) {
        const [options, expected] = kinds[next++ % kinds.length];
        const { status } = await send('/api/open', options).catch(error => ({ status: error.code }));
        statuses.set(status, (statuses.get(status) ?? 0) + 1);
        const lawful = expected.includes(status) || (options.method === undefined && [404].includes(status)) || status === 'ECONNRESET';
        assert.ok(lawful, `${JSON.stringify(options)} got ${status}`);
      }
    };
    await Promise.all(Array.from({ length: 24 }, client));
    await still_works();
    console.log(`  ${count} requests in ${((Date.now() - begin) / 1000).toFixed(1)} s: ${[...statuses].map(([s, n]) => `${s} ${n} times`).join(', ')}; ${before.toFixed(0)} MB before, ${memory().toFixed(0)} after`);
    assert.ok(memory() - before < 24, 'memory stays');
  },

  async a_body_of_a_gigabyte_is_not_taken() {
    const before = memory();
    for (const chunked of [false, true]) {
      const sent = await new Promise(done => {
        const socket = net.connect(Number(port), '127.0.0.1');
        let bytes = 0, answer = '';
        socket.on('data', data => { answer += data; });
        socket.on('error', () => {});
        socket.on('close', () => done({ bytes, answer }));
        socket.write(`POST /api/save HTTP/1.1\r\nHost: 127.0.0.1:${port}\r\nCookie: ${cookie}\r\nOrigin: ${origin}\r\nContent-Type: application/json\r\n${chunked ? 'Transfer-Encoding: chunked' : `Content-Length: ${gigabyte}`}\r\n\r\n`);
        const part = Buffer.alloc(2 ** 16, 'x');
        const more = () => {
          while (!socket.destroyed && bytes < gigabyte) {
            bytes += part.length;
            const goes_on = chunked ? [socket.write('10000\r\n'), socket.write(part), socket.write('\r\n')].every(Boolean) : socket.write(part);
            if (!goes_on) return socket.once('drain', more);
          }
          return undefined;
        };
        more();
      });
      console.log(`  ${chunked ? 'in chunks' : 'announced'}: ${(sent.bytes / 2 ** 20).toFixed(1)} MB went out before it hung up: ${sent.answer.split('\r\n')[0] || 'no answer'}`);
      assert.ok(sent.bytes < 64 * 2 ** 20);
      assert.match(sent.answer || 'HTTP/1.1 413', /^HTTP\/1\.1 413/);
    }
    assert.ok(memory() - before < 24);
    await still_works();
  },

  async no_parameter_leads_out_of_the_folder() {
    const out = basename(studio.folder);
    const names = [`../${out}.secret.pxm`, `..%2f${out}.secret.pxm`, `${studio.folder}.secret.pxm`, `x/../../${out}.secret.pxm`, `./../${out}.secret.pxm`, '.hidden/a.pxm', 'link.pxm',
      `..\\${out}.secret.pxm`, `tetra.pxm/../../${out}.secret.pxm`, `file://${studio.folder}.secret.pxm`, `a\u0000/../../${out}.secret.pxm`, '/etc/passwd', '../../../../../etc/passwd', `~/${out}.pxm`, '', '.', '..', '/'];
    const beside = readdirSync(dirname(studio.folder)).sort();
    const within = readdirSync(studio.folder).sort();
    const whole = { open: { name: 'tetra.pxm' }, save: { name: 'tetra.pxm', text: '# changed', seen: '' }, check: picture, inspect: picture, picture, png: picture, pick: { ...picture, x: 1, y: 1 }, pixel: { ...picture, x: 1, y: 1 },
      progress: { view: 'test-picture' }, leave: { view: 'test-none' }, import: { view: 'test-import', name: 'a.ifs', data: '', entry: '' }, study: { view: 'test-study', name: 'tetra.pxm', text: 'x', kind: 'balance', columns: 8, rows: 8 },
      export: { ...picture, view: 'test-export', file: 'a.nothing', levels: 1 } };
    let asked = 0;
    for (const [path, question] of Object.entries(whole)) {
      for (const key of Object.keys(question)) {
        for (const name of names) {
          const value = key === 'settings' ? [`render.heap=${name}`] : key === 'text' ? `include "${name}"\n` : key === 'file' && name !== 'link.pxm' ? name.replace(/pxm$/, 'obj') : name;
          let answer = await ask(`/api/${path}`, { serial: ++serial, ...question, [key]: value });
          for (; answer.status === 429; answer = await ask(`/api/${path}`, { serial: ++serial, ...question, [key]: value })) await pause(50);
          assert.ok(!answer.body.includes(secret) && !answer.body.includes('root:'), `${path} ${key} ${name}`);
          ++asked;
        }
      }
    }
    for (const name of names) {
      const { status, body } = await send(`/${encodeURI(name).replaceAll('\u0000', '%00')}`, { headers: known });
      assert.ok([200, 400, 404, 429].includes(status) && !body.includes(secret) && !body.includes('root:'), name);
    }
    console.log(`  ${asked} questions`);
    assert.deepEqual(readdirSync(dirname(studio.folder)).filter(n => n.startsWith(out)).sort(), beside.filter(n => n.startsWith(out)));
    assert.deepEqual(readdirSync(studio.folder).sort(), within, 'nothing was written');
    assert.equal(readFileSync(join(studio.folder, 'tetra.pxm'), 'utf8'), tetra);
    assert.equal(readFileSync(`${studio.folder}.secret.pxm`, 'utf8'), secret);
    await still_works();
  },

  async names_with_markup_are_names() {
    const opened = await openPage(context, studio.address);
    const { page } = opened;
    await page.waitForSelector('#own-cards .caption');
    assert.ok((await page.textContent('#own-cards')).includes('<img src=x'));
    await page.click('#own-cards button[title^="<img"]');
    await settled(page);
    assert.ok((await page.textContent('#scene-name')).includes('<img src=x'));
    await page.click('#tab-text');
    await page.setInputFiles('#file', { name: '<b onclick=x>.pxm', mimeType: 'text/plain', buffer: Buffer.from('ifs a { newmap <script>window.stolen=1</script> }') });
    await page.waitForSelector('#mistakes .mistake');
    assert.equal(await page.evaluate(() => window.stolen), undefined);
    assert.equal((await page.$$('#studio img, #studio script, #studio b[onclick]')).length, 0);
    assert.deepEqual(opened.complaints, []);
    await page.close();
  },

  async who_is_killed_while_it_saves_leaves_the_old_file_or_the_new() {
    const rounds = many ? 60 : 8;
    const found = { old: 0, new: 0 };
    for (let round = 0; round < rounds; ++round) {
      const mortal = await startStudio(program, fill);
      const at = new URL(mortal.address);
      const enter = await send(at.pathname + at.search, { to: at.port });
      const headers = { Cookie: enter.fields['set-cookie'][0].split(';')[0], 'Content-Type': 'application/json', Origin: at.origin };
      const old = `# old ${'o'.repeat(900_000)}\n`, fresh = `# new ${'n'.repeat(900_000)}\n`;
      const file = join(mortal.folder, 'saved.pxm');
      const save = (text, seen) => send('/api/save', { to: at.port, method: 'POST', headers, body: JSON.stringify({ name: 'saved.pxm', text, seen }) }).then(r => JSON.parse(r.body));
      const begin = performance.now();
      const { digest } = await save(old, '');
      assert.ok(digest);
      const took = performance.now() - begin;
      const saving = save(fresh, digest).catch(() => null);
      await pause(2 * took * round / rounds);  // from before it has come until it is done
      mortal.child.kill('SIGKILL');
      await saving;
      await mortal.ended;
      const text = readFileSync(file, 'utf8');
      assert.ok(text === old || text === fresh, `round ${round}: ${text.length} bytes`);
      ++found[text === old ? 'old' : 'new'];
      assert.deepEqual(readdirSync(mortal.folder).filter(n => n.endsWith('.pxm') && n.startsWith('saved')), ['saved.pxm']);
      await mortal.stop();
      rmSync(`${mortal.folder}.secret.pxm`, { force: true });
    }
    console.log(`  the old file ${found.old} times, the new one ${found.new} times`);
    assert.ok(found.old > 0 && found.new > 0, 'some were killed before it was done, and some after');
  },

  async memory_is_flat_over_many_events() {
    const events = many ? 10_000 : 1_000;
    const opened = await openPage(context, studio.address, '#scene=tetra.pxm');
    const { page } = opened;
    await settled(page);
    await page.click('.map-title >> nth=0');
    const session = await page.context().newCDPSession(page);
    const heap = async () => { await session.send('HeapProfiler.collectGarbage'); return (await session.send('Runtime.getHeapUsage')).usedSize / 2 ** 20; };
    const turn = count => page.evaluate(async n => {
      const place = document.getElementById('handles');
      const at = (type, x, y) => place.dispatchEvent(new PointerEvent(type, { pointerId: 1, clientX: x, clientY: y, button: 0, bubbles: true }));
      place.setPointerCapture = () => {};
      const box = place.getBoundingClientRect();
      for (let i = 0; i < n; ++i) {
        if (i % 50 === 0) at('pointerdown', box.right - 30, box.bottom - 30);
        at('pointermove', box.right - 30 + 20 * Math.sin(i / 7), box.bottom - 30 + 10 * Math.cos(i / 9));
        if (i % 50 === 49) { at('pointerup', box.right - 30, box.bottom - 30); await new Promise(done => setTimeout(done, 8)); }
      }
    }, count);
    await turn(events / 5);  // what is made once has been made
    await settled(page);
    const before = { program: memory(), page: await heap() };
    await turn(events);
    await settled(page);
    const after = { program: memory(), page: await heap() };
    console.log(`  ${events} events: the program ${before.program.toFixed(0)} MB, then ${after.program.toFixed(0)}; the page ${before.page.toFixed(1)} MB, then ${after.page.toFixed(1)}`);
    assert.ok(after.program - before.program < 24 && after.page - before.page < 4, 'memory is flat');
    assert.deepEqual(opened.complaints, []);
    await page.close();
  },
};

let passed = 0, failed = 0;
try {
  for (const [name, test] of Object.entries(tests)) {
    if (only && !name.includes(only)) continue;
    const begin = Date.now();
    try {
      await test();
      console.log(`${name}: ${((Date.now() - begin) / 1000).toFixed(1)} s`);
      ++passed;
    } catch (error) {
      console.log(`${name} FAILED: ${error.stack}`);
      ++failed;
    }
  }
} finally {
  await browser.close();
  agent.destroy();
  await studio.stop();
  rmSync(`${studio.folder}.secret.pxm`, { force: true });
}
console.log(`${passed} passed, ${failed} failed`);
process.exitCode = failed > 0 ? 1 : 0;
