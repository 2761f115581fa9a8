// Browsers start no worker for a page that was opened as a file. There, a hidden frame does the work of the search's worker.
if (location.protocol === "file:") {
    window.Worker = class extends EventTarget {
        constructor(url) {
            super();
            this.queue = [];
            this.frame = document.createElement("iframe");
            this.frame.hidden = true;
            document.body.appendChild(this.frame);
            const page = this.frame.contentDocument;
            page.open();
            page.write(`<script>
                postMessage = message => parent.postMessage({ from: "worker", message }, "*");
                importScripts = (...urls) => urls.reduce((before, url) => before.then(() => new Promise((done, failed) => {
                    const script = document.createElement("script");
                    script.src = url;
                    script.onload = done;
                    script.onerror = failed;
                    document.body.appendChild(script);
                })), Promise.resolve());
                addEventListener("message", event => { if (event.data.from === "page") {
                    event.stopImmediatePropagation();
                    dispatchEvent(new MessageEvent("message", { data: event.data.message }));
                } });
            <\/script><body><script src="${url}"><\/script>`);
            page.close();
            this.frame.onload = () => { this.is_loaded = true; this.queue.splice(0).forEach(message => this.postMessage(message)); };
            window.addEventListener("message", event => {
                if (event.source !== this.frame.contentWindow || event.data.from !== "worker") return;
                const answer = new MessageEvent("message", { data: event.data.message });
                this.dispatchEvent(answer);
                if (this.onmessage) this.onmessage(answer);
            });
        }
        postMessage(message) {
            if (this.is_loaded) this.frame.contentWindow.postMessage({ from: "page", message }, "*");
            else this.queue.push(message);
        }
        terminate() { this.frame.remove(); }
    };
}
