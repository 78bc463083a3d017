#include "widgets/spoken_label.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QCoreApplication>
#include <QVariant>

namespace carina
{
namespace
{

constexpr const char* kSpokenInstead = "spokenInstead";

class SpokenLabel : public QAccessibleWidget
{
public:
    explicit SpokenLabel(QLabel* label) : QAccessibleWidget{label, QAccessible::StaticText} {}

    [[nodiscard]] QString text(QAccessible::Text which) const override
    {
        if (which != QAccessible::Name)
            return QAccessibleWidget::text(which);
        const auto& label = static_cast<const QLabel&>(*widget());
        const QString name = label.accessibleName();
        if (label.text().isEmpty() || label.property(kSpokenInstead).toBool())
            return name;
        return QCoreApplication::translate("SpokenLabel", "%1: %2", "what it is about; its text")
            .arg(name, label.text());
    }
};

/// Only for labels with a name: of others Qt gives the text, or what they are the label of.
QAccessibleInterface* spokenLabel(const QString&, QObject* object)
{
    auto* label = qobject_cast<QLabel*>(object);
    return label && !label->accessibleName().isEmpty() ? new SpokenLabel{label} : nullptr;
}

} // namespace

void installSpokenLabels() { QAccessible::installFactory(spokenLabel); }

void speakInstead(QLabel& label, const QString& words)
{
    label.setProperty(kSpokenInstead, true);
    label.setAccessibleName(words);
}

} // namespace carina
