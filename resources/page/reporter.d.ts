// SPDX-License-Identifier: Apache-2.0
// Where answers go: report_*.js have one for each kind of learning system.

import type { Facts } from "./facts.d.ts";

export interface Answer {
  id: string;
  kind: string;
  words: string;
  response: string;
  correct: boolean;
  seconds: number;
}

export interface Reporter {
  /** Returns what an attempt that was suspended has answered already. */
  begin(total: number): Promise<{ answered: { [question: string]: boolean } }>;
  answer(answer: Answer): void;
  end(right: number, total: number): void;
  suspend(): void;
}

/** Nobody is told where there is no kind. */
export type CreateReporter = (kind: Facts["report"]) => Reporter;
