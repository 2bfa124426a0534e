// The language of scenes, from the table of commands, and the names that snell gives to shaders.
import written from './words.json';

export interface Command {
    name: string;
    alias?: string;
    signature: string;
    doc: string;
}

export interface Variable {
    name: string;
    type: string;
    doc: string;
}

export const commands: readonly Command[] = written.commands;
export const choices: readonly string[] = written.choices;
export const variables: readonly Variable[] = written.variables;

const byName = new Map<string, Command>();
for (const command of commands)
    for (const name of [command.name, command.alias ?? command.name]) byName.set(name.toLowerCase(), command);

// Commands are written in upper or lower case.
export function findCommand(word: string): Command | undefined {
    return byName.get(word.toLowerCase());
}
