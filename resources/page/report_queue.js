// SPDX-License-Identifier: Apache-2.0
// Keeps what is to be told to a learning system until it has arrived: in memory alone, in order.

/** Milliseconds before another try, which double with each that fails. */
const firstWait = 1000;
const longestWait = 60_000;

/**
 * @template Job
 */
export class DeliveryQueue {
  /**
   * @param {(jobs: readonly Job[]) => number | Promise<number>} deliver tells how many of the first
   * jobs have arrived; throws or rejects where it cannot tell
   */
  constructor(deliver) {
    this.deliver = deliver;
    /** @type {Job[]} */
    this.jobs = [];
    this.busy = false;
    this.failures = 0;
    /** @type {number | undefined} */
    this.timer = undefined;
    window.addEventListener("online", () => this.flush());
    document.addEventListener("visibilitychange", () => {
      if (document.visibilityState === "hidden") this.flush();
    });
  }

  /** @param {Job} job */
  add(job) {
    this.jobs.push(job);
    this.flush();
  }

  /** Tries to deliver all at once. */
  flush() {
    if (this.busy || !this.jobs.length) return;
    window.clearTimeout(this.timer);
    /** @type {number | Promise<number>} */
    let arrived = 0;
    try {
      arrived = this.deliver(this.jobs);
    } catch {
      arrived = 0;
    }
    if (typeof arrived === "number") {
      this.settle(arrived);
      return;
    }
    this.busy = true;
    arrived
      .catch(() => 0)
      .then((count) => {
        this.busy = false;
        this.settle(count);
        if (count && this.jobs.length) this.flush();
      });
  }

  /** @param {number} arrived */
  settle(arrived) {
    this.jobs.splice(0, arrived);
    this.failures = arrived || !this.jobs.length ? 0 : this.failures + 1;
    if (!this.jobs.length) return;
    const wait = Math.min(longestWait, firstWait * 2 ** Math.max(0, this.failures - 1));
    this.timer = window.setTimeout(() => this.flush(), wait);
  }
}
