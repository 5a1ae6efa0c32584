import { basicSetup } from "codemirror";
import { EditorView, keymap } from "@codemirror/view";
import { EditorState } from "@codemirror/state";
import { indentWithTab } from "@codemirror/commands";
import { rust } from "@codemirror/lang-rust";
import { lintGutter, setDiagnostics } from "@codemirror/lint";

export function editor(parent, doc, onChange) {
  const changed = EditorView.updateListener.of((update) => update.docChanged && onChange(update.state.doc.toString()));
  const extensions = [basicSetup, keymap.of([indentWithTab]), rust(), lintGutter(), changed, EditorView.lineWrapping];
  const view = new EditorView({ parent, state: EditorState.create({ doc, extensions }) });
  return {
    text: () => view.state.doc.toString(),
    replace: (text) => view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: text } }),
    mark: (diagnostics) => {
      const most = view.state.doc.length;
      const inside = diagnostics.map((one) => ({ ...one, from: Math.min(one.from, most), to: Math.min(one.to, most) }));
      view.dispatch(setDiagnostics(view.state, inside));
    },
  };
}
