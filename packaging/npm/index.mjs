// SPDX-License-Identifier: GPL-3.0-or-later
import both from './index.cjs';
export const { ashimpact } = both;
