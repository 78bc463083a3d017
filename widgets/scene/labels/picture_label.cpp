#include "widgets/scene/labels/picture_label.h"

#include "widgets/plain_label.h"

#include <QLabel>
#include <QWindow>

namespace carina
{
namespace
{

constexpr int kLabelMargin = 3; ///< pixels around a word
constexpr const char* kLabelStyle = "QLabel { color: #ffffff; background: #10181f; }";

} // namespace

QLabel* pictureLabel(QWidget& over, const QString& word)
{
    auto* label = new PlainLabel{word, &over};
    label->setAttribute(Qt::WA_NativeWindow); // else the scene's own window would cover it
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    label->setStyleSheet(QString::fromLatin1(kLabelStyle));
    label->setAutoFillBackground(true);
    label->setMargin(kLabelMargin);
    label->adjustSize();
    label->hide();
    return label;
}

void raiseLabel(QLabel& label)
{
    if (QWindow* window = label.windowHandle())
        window->raise();
}

} // namespace carina
