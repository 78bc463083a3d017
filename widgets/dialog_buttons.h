#pragma once

#include <QDialogButtonBox>
#include <QPushButton>

namespace carina
{

/// Makes Tab go from the button that a dialog is for to *Cancel*: Qt 6.4 leaves a standard button
/// out of the way of Tab when another one was added to its box. @pre the box is in its dialog
inline void leadTabToCancel(const QDialogButtonBox& buttons, QPushButton& accept)
{
    QWidget::setTabOrder(&accept, buttons.button(QDialogButtonBox::Cancel));
}

} // namespace carina
