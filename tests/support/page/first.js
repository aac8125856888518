// SPDX-License-Identifier: Apache-2.0
const closing = "</script>" + "<!--";
