#pragma once

#include "widgets/scene/look/part_look.h"

#include <QWidget>

#include <functional>
#include <vector>

class QLineEdit;
class QPushButton;
class QTreeWidget;

namespace carina
{

class SceneView;

/// Which parts of the patient a view shows, and how: solid, as a ghost, hidden, highlighted, with
/// its name beside it, in a plain colour. What is chosen in the list, by mouse or keyboard, is what
/// the buttons are about; the words typed above it leave out all other parts.
class PartsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit PartsPanel(QWidget* parent = nullptr);

    /// Lists the parts that the view has now. @pre the view outlives the panel.
    void setScene(SceneView& scene);

private:
    void layOut();
    [[nodiscard]] QPushButton* styleButton(const QString& text, const QString& toolTip,
                                           PartStyle style);
    /// A button and what of a look it switches on and off.
    struct Switch {
        QPushButton* button;
        bool PartLook::*which;
    };
    [[nodiscard]] Switch switchFor(const QString& text, const QString& toolTip,
                                   bool PartLook::*which);
    [[nodiscard]] static QString wordsFor(const PartLook& look);
    [[nodiscard]] std::vector<std::uint16_t> chosen() const;
    void changeChosen(const std::function<void(PartLook&)>& change);
    void showAll();
    void filter(const QString& words);
    void refresh();

    SceneView* m_scene = nullptr;
    QLineEdit* m_words;
    QTreeWidget* m_parts;
    std::vector<QPushButton*> m_styles;
    Switch m_highlight;
    Switch m_label;
    Switch m_plain; ///< shown only where a part came with colours
    QPushButton* m_showAll;
};

} // namespace carina
