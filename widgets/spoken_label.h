#pragma once

#include <QLabel>

namespace carina
{

/// Lets programs that read windows aloud say of each label both its accessible name and its text,
/// "Code for trainees: 7K3QM-XW2PD". Qt by itself gives them the name in place of the text, so that
/// nobody hears what the label shows. Called once, by each program.
void installSpokenLabels();

/// For a label that shows less than there is to say, or with other marks: these words are said
/// alone, and not its text.
void speakInstead(QLabel& label, const QString& words);

} // namespace carina
