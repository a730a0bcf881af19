// Starts the worker while the browser still reads the rest of the page: this script comes before the large blocks.

interface Rules {
  createScriptURL(text: string): string;
}

const { trustedTypes } = globalThis as { trustedTypes?: { createPolicy(name: string, rules: Rules): Rules } };
// The only place where text becomes the address of a script. The name of the policy is also in web/build/policy.mjs.
const rules = trustedTypes?.createPolicy("osim-worker", { createScriptURL: (text) => text });
const script = document.getElementById("worker")?.textContent ?? "";
const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
const worker = new Worker(rules?.createScriptURL(address) ?? address);
// Resolved by the first message of the worker.
const startedWorker = new Promise<Worker>((resolve, reject) => {
  worker.onmessage = () => resolve(worker);
  worker.onerror = ({ message }) => reject(new Error(message));
});
Object.assign(globalThis, { startedWorker });
