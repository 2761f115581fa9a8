// Browsers start no worker for a page that was opened as a file. There, a hidden frame does the work of the search's worker.
if (location.protocol === "file:") {
    window.Worker = class extends EventTarget {
        constructor(url) {
            super();
            this.frame = document.createElement("iframe");
            this.frame.hidden = true;
            document.body.appendChild(this.frame);
            const scope = this.frame.contentWindow;
            scope.postMessage = message => setTimeout(() => this.answer(message));
            scope.importScripts = (...urls) => urls.reduce((before, next) => before.then(() => this.load(next)), Promise.resolve());
            this.loaded = this.load(url);
        }
        load(url) {
            const page = this.frame.contentDocument, script = page.createElement("script");
            script.src = url;
            return new Promise((done, failed) => {
                script.onload = done;
                script.onerror = failed;
                page.body.appendChild(script);
            });
        }
        answer(message) {
            const event = new MessageEvent("message", { data: message });
            this.dispatchEvent(event);
            if (this.onmessage) this.onmessage(event);
        }
        postMessage(message) {
            const scope = this.frame.contentWindow;
            this.loaded.then(() => scope.dispatchEvent(new scope.MessageEvent("message", { data: message })));
        }
        terminate() { this.frame.remove(); }
    };
}
