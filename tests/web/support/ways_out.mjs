// All known ways in which a page can reach a server. Runs inside the page, as its only script.

/** The text of a script that tries the ways `names` to reach `host` after its button is clicked. */
export function waysOut(host, names) {
  return `(${everything})(${JSON.stringify(host)}, ${JSON.stringify(names ?? null)});`;
}

function everything(host, names) {
  const at = (name) => `http://${host}/${name}`;
  const add = (tag, attributes, parent = document.body) => {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    parent.append(element);
    return element;
  };
  const link = (rel, more = {}) => add("link", { rel, href: at(rel), ...more }, document.head);
  const inWorker = (text) => new Worker(URL.createObjectURL(new Blob([text], { type: "text/javascript" })));
  const submit = (name, attributes) => {
    const form = add("form", { action: at(name), ...attributes });
    add("input", { name: "model", value: "secret" }, form);
    form.submit();
  };
  const ways = {
    fetch: (name) => fetch(at(name)),
    "fetch-no-cors": (name) => fetch(at(name), { mode: "no-cors", method: "POST", body: "secret" }),
    "fetch-keepalive": (name) => fetch(at(name), { keepalive: true, mode: "no-cors" }),
    xhr: (name) => {
      const request = new XMLHttpRequest();
      request.open("POST", at(name));
      request.send("secret");
    },
    beacon: (name) => navigator.sendBeacon(at(name), "secret"),
    image: (name) => (new Image().src = at(name)),
    "image-in-the-page": (name) => add("img", { src: at(name) }),
    "image-in-svg": (name) => {
      const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
      const image = document.createElementNS("http://www.w3.org/2000/svg", "image");
      image.setAttribute("href", at(name));
      svg.append(image);
      document.body.append(svg);
    },
    background: (name) => (document.body.style.backgroundImage = `url(${at(name)})`),
    font: (name) => new FontFace("other", `url(${at(name)})`).load(),
    audio: (name) => add("audio", { src: at(name), preload: "auto" }),
    video: (name) => add("video", { src: at(name), preload: "auto" }),
    poster: (name) => add("video", { poster: at(name) }),
    object: (name) => add("object", { data: at(name) }),
    embed: (name) => add("embed", { src: at(name) }),
    iframe: (name) => add("iframe", { src: at(name) }),
    "iframe-srcdoc": (name) => add("iframe", { srcdoc: `<img src="${at(name)}">` }),
    "script-element": (name) => add("script", { src: at(name) }),
    import: (name) => import(at(name)),
    worker: (name) => new Worker(at(name)),
    "worker-imports": (name) => inWorker(`importScripts("${at(name)}")`),
    "worker-fetches": (name) => inWorker(`fetch("${at(name)}", { mode: "no-cors" })`),
    "shared-worker": (name) => new SharedWorker(at(name)),
    websocket: (name) => new WebSocket(`ws://${host}/${name}`),
    eventsource: (name) => new EventSource(at(name)),
    webtransport: (name) => new WebTransport(`https://${host}/${name}`),
    stylesheet: (name) => link(name),
    prefetch: (name) => link(name),
    preload: (name) => link(name, { as: "fetch", crossorigin: "" }),
    modulepreload: (name) => link(name),
    preconnect: (name) => link(name),
    prerender: (name) => link(name),
    manifest: (name) => link(name),
    icon: (name) => link(name),
    speculation: (name) => {
      const rules = add("script", { type: "speculationrules" }, document.createElement("div"));
      rules.textContent = JSON.stringify({ prefetch: [{ source: "list", urls: [at(name)] }] });
      document.head.append(rules);
    },
    ping: (name) => add("a", { href: "#here", ping: at(name) }).click(),
    form: (name) => submit(name, { method: "post", target: add("iframe", { name: "hidden" }).name }),
    "form-get": (name) => submit(name, { method: "get", target: "hidden" }),
    refresh: (name) => add("iframe", { srcdoc: `<meta http-equiv="refresh" content="0;url=${at(name)}">` }),
    "turn-server": async () => {
      const peer = new RTCPeerConnection({ iceServers: [{ urls: `turn:${host}?transport=tcp`, username: "a", credential: "b" }] });
      peer.createDataChannel("way");
      await peer.setLocalDescription(await peer.createOffer());
    },
    "window-open": (name) => window.open(at(name)),
    "link-new-window": (name) => add("a", { href: at(name), target: "_blank" }).click(),
    "form-new-window": (name) => submit(name, { method: "post", target: "_blank" }),
  };
  document.body.append(Object.assign(document.createElement("button"), {
    textContent: "Try",
    onclick: async () => {
      for (const [name, way] of Object.entries(ways)) {
        if (names && !names.includes(name)) continue;
        try {
          Promise.resolve(way(name)).catch(() => undefined);
        } catch {
          // Refused at once.
        }
      }
      document.body.dataset.tried = "true";
    },
  }));
}

/** The names of all ways. */
export const NAMES = namesIn(everything.toString().split("const ways")[1].split("\n  };")[0]);

function namesIn(text) {
  return [...text.matchAll(/^ {4}"?([a-z-]+)"?: (?:async )?\([^()]*\) =>/gm)].map(([, name]) => name);
}
