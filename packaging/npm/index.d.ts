// SPDX-License-Identifier: GPL-3.0-or-later

/** What a command did. */
export interface Ended {
    /** 0 done, 2 the input is wrong, 3 not converged, 1 a defect of the program. */
    status: number;
    /** Results, as on the command line. */
    stdout: string;
    /** Messages, as on the command line. */
    stderr: string;
    /** All files after the command, those given and those written, by their path. */
    files: Record<string, Uint8Array>;
}

/**
 * Runs one command of ashimpact on files in memory.
 *
 *     const { status, stdout } = await ashimpact(['modulus', 'ash.csv', '--json'], { files: { 'ash.csv': text } });
 *
 * @param words what follows `ashimpact` on a command line
 * @param given files by their path, and what the command reads from standard input
 */
export function ashimpact(
    words: string[],
    given?: { files?: Record<string, string | Uint8Array>; input?: string | Uint8Array },
): Promise<Ended>;
