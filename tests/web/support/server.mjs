// A small server of files, and a listener that counts who reaches it.

import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { createServer as createListener } from "node:net";

import { PAGE } from "./places.mjs";

const NAME = "/osim-contact-scale.html";

/** Serves the page, or `html` in its place: any static server does. `requests` lists the requested addresses. */
export async function serve(html) {
  const requests = [];
  const server = createServer((request, response) => {
    requests.push(request.url);
    if (request.url !== NAME) return response.writeHead(404).end();
    response.writeHead(200, { "Content-Type": "text/html" }).end(html ?? readFileSync(PAGE));
  });
  const port = await listening(server);
  return { page: `http://127.0.0.1:${port}${NAME}`, requests, end: () => endOfServer(server) };
}

/** Listens for any connection, of any protocol: `reached` is what the first bytes of each were. */
export async function listen() {
  const reached = [];
  const server = createListener((socket) => {
    const index = reached.push("(connected)") - 1;
    socket.on("error", () => undefined);
    socket.once("data", (bytes) => {
      reached[index] = bytes.toString("latin1").split("\r\n")[0];
      socket.end("HTTP/1.1 200 OK\r\nContent-Type: text/html\r\nContent-Length: 2\r\nConnection: close\r\n\r\nok");
    });
  });
  const port = await listening(server);
  return { host: `127.0.0.1:${port}`, reached, end: () => endOfServer(server) };
}

function listening(server) {
  return new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(server.address().port)));
}

function endOfServer(server) {
  server.closeAllConnections?.();
  return new Promise((resolve) => server.close(resolve));
}
