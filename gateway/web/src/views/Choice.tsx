/** A few words of which one holds. */
export function Choice<Word extends string>(props: {
  legend: string;
  words: readonly Word[];
  chosen: Word;
  text: (word: Word) => string;
  choose: (word: Word) => void;
  lang?: (word: Word) => string;
}) {
  return (
    <fieldset class="choice">
      <legend>{props.legend}</legend>
      {props.words.map((word) => (
        <button
          type="button"
          key={word}
          data-word={word}
          {...(props.lang === undefined ? {} : { lang: props.lang(word) })}
          aria-pressed={props.chosen === word}
          onClick={() => props.choose(word)}
        >
          {props.text(word)}
        </button>
      ))}
    </fieldset>
  );
}
