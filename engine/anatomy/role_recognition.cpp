#include "engine/anatomy/role_recognition.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <string>

namespace carina
{
namespace
{

struct ConceptRole {
    int first; ///< a run of FMA numbers
    int last;
    PartRole role;
};

constexpr std::array kConceptRoles{
    ConceptRole{7088, 7088, PartRole::Heart},
    ConceptRole{7131, 7131, PartRole::Oesophagus},
    ConceptRole{7163, 7163, PartRole::Skin},
    ConceptRole{7309, 7309, PartRole::RightLung},
    ConceptRole{7310, 7310, PartRole::LeftLung},
    ConceptRole{7333, 7333, PartRole::RightUpperLobe},
    ConceptRole{7337, 7337, PartRole::RightLowerLobe},
    ConceptRole{7370, 7370, PartRole::LeftUpperLobe},
    ConceptRole{7371, 7371, PartRole::LeftLowerLobe},
    ConceptRole{7383, 7383, PartRole::RightMiddleLobe},
    ConceptRole{7394, 7394, PartRole::Trachea},
    ConceptRole{7395, 7395, PartRole::RightMainBronchus},
    ConceptRole{7396, 7396, PartRole::LeftMainBronchus},
    ConceptRole{9615, 9615, PartRole::Larynx}, // cricoid cartilage
    ConceptRole{13295, 13295, PartRole::Diaphragm},
    ConceptRole{46688, 46688, PartRole::Pharynx},
    ConceptRole{52748, 52748, PartRole::Mandible},
    ConceptRole{52749, 52749, PartRole::Hyoid},
    ConceptRole{54640, 54640, PartRole::Tongue},
    ConceptRole{55097, 55097, PartRole::Larynx},
    ConceptRole{55099, 55099, PartRole::Larynx}, // thyroid cartilage
    ConceptRole{55113, 55118, PartRole::Larynx}, // arytenoid, corniculate, cuneiform cartilages
    ConceptRole{55130, 55130, PartRole::Epiglottis},
    ConceptRole{55245, 55246, PartRole::Larynx},        // vocal ligaments
    ConceptRole{68211, 68233, PartRole::BronchialTree}, // segmental bronchial trees
    ConceptRole{68321, 68321, PartRole::BronchialTree},
    ConceptRole{68418, 68418, PartRole::RightMainBronchus},
};

struct PhraseRole {
    std::string_view phrase; ///< whole words
    PartRole role;
    PartRole left; ///< the role where the name speaks of the left side
};

constexpr PhraseRole both(std::string_view phrase, PartRole role) { return {phrase, role, role}; }

/// The first phrase that a name holds decides: "Bronchial branch of arch of aorta" is a vessel.
constexpr std::array kPhraseRoles{
    both("aorta", PartRole::Vessel),
    both("artery", PartRole::Vessel),
    both("arteries", PartRole::Vessel),
    both("vein", PartRole::Vessel),
    both("veins", PartRole::Vessel),
    both("vena cava", PartRole::Vessel),
    both("pulmonary trunk", PartRole::Vessel),
    PhraseRole{"main bronchus", PartRole::RightMainBronchus, PartRole::LeftMainBronchus},
    PhraseRole{"principal bronchus", PartRole::RightMainBronchus, PartRole::LeftMainBronchus},
    both("bronchus", PartRole::BronchialTree),
    both("bronchi", PartRole::BronchialTree),
    both("bronchial", PartRole::BronchialTree),
    PhraseRole{"upper lobe", PartRole::RightUpperLobe, PartRole::LeftUpperLobe},
    PhraseRole{"superior lobe", PartRole::RightUpperLobe, PartRole::LeftUpperLobe},
    PhraseRole{"middle lobe", PartRole::RightMiddleLobe, PartRole::Other},
    PhraseRole{"lower lobe", PartRole::RightLowerLobe, PartRole::LeftLowerLobe},
    PhraseRole{"inferior lobe", PartRole::RightLowerLobe, PartRole::LeftLowerLobe},
    PhraseRole{"lung", PartRole::RightLung, PartRole::LeftLung},
    both("trachea", PartRole::Trachea),
    both("vocal fold", PartRole::VocalFold),
    both("vestibular fold", PartRole::LaryngealMucosa),
    both("aryepiglottic fold", PartRole::LaryngealMucosa),
    both("glosso epiglottic fold", PartRole::Mucosa),
    both("cuneiform tubercle", PartRole::LaryngealMucosa),
    both("corniculate tubercle", PartRole::LaryngealMucosa),
    both("palatoglossal arch", PartRole::Pharynx),
    both("palatopharyngeal arch", PartRole::Pharynx),
    both("palatine tonsil", PartRole::Pharynx),
    both("pharyngeal mucosa", PartRole::Pharynx),
    both("laryngeal mucosa", PartRole::LaryngealMucosa),
    both("vallecula", PartRole::LaryngealMucosa),
    both("mucosa", PartRole::Mucosa),
    both("gingiva", PartRole::Mucosa),
    both("lip", PartRole::Mucosa),
    both("epiglottis", PartRole::Epiglottis),
    both("diaphragm", PartRole::Diaphragm),
    both("larynx", PartRole::Larynx),
    both("thyroid cartilage", PartRole::Larynx),
    both("cricoid", PartRole::Larynx),
    both("arytenoid", PartRole::Larynx),
    both("corniculate cartilage", PartRole::Larynx),
    both("cuneiform cartilage", PartRole::Larynx),
    both("cricothyroid", PartRole::Larynx),
    both("aryepiglotticus", PartRole::Larynx),
    both("epiglottic", PartRole::Larynx),
    both("thyrohyoid membrane", PartRole::Larynx),
    both("thyrohyoid ligament", PartRole::Larynx),
    both("vocal ligament", PartRole::Larynx),
    both("vocalis", PartRole::Larynx),
    both("hyoid", PartRole::Hyoid),
    both("ligament", PartRole::Other),
    both("gland", PartRole::Other),
    both("tooth", PartRole::Tooth),
    both("teeth", PartRole::Tooth),
    both("incisor", PartRole::Tooth),
    both("tongue", PartRole::Tongue),
    both("genioglossus", PartRole::Tongue),
    both("hyoglossus", PartRole::Tongue),
    both("styloglossus", PartRole::Tongue),
    both("pharynx", PartRole::Pharynx),
    both("pharyngeal constrictor", PartRole::Pharynx),
    both("pharyngeal raphe", PartRole::Pharynx),
    both("palatopharyngeus", PartRole::Pharynx),
    both("salpingopharyngeus", PartRole::Pharynx),
    both("stylopharyngeus", PartRole::Pharynx),
    both("veli palatini", PartRole::Pharynx),
    both("uvular muscle", PartRole::Pharynx),
    both("uvula", PartRole::Pharynx),
    both("soft palate", PartRole::Pharynx),
    both("hard palate", PartRole::Pharynx),
    both("oral cavity", PartRole::Pharynx),
    both("esophagus", PartRole::Oesophagus),
    both("oesophagus", PartRole::Oesophagus),
    both("mandible", PartRole::Mandible),
    both("skull", PartRole::Skull),
    both("cranium", PartRole::Skull),
    both("alar cartilage", PartRole::Skull),
    both("nasal cartilage", PartRole::Skull),
    both("nasal concha", PartRole::Skull),
    both("nasal bone", PartRole::Skull),
    both("ethmoid", PartRole::Skull),
    both("frontal bone", PartRole::Skull),
    both("lacrimal bone", PartRole::Skull),
    both("maxilla", PartRole::Skull),
    both("palatine bone", PartRole::Skull),
    both("parietal bone", PartRole::Skull),
    both("temporal bone", PartRole::Skull),
    both("zygomatic bone", PartRole::Skull),
    both("occipital bone", PartRole::Skull),
    both("sphenoid", PartRole::Skull),
    both("vomer", PartRole::Skull),
    both("vertebra", PartRole::Spine),
    both("intervertebral disk", PartRole::Spine),
    both("intervertebral disc", PartRole::Spine),
    both("atlas", PartRole::Spine),
    both("axis", PartRole::Spine),
    both("spine", PartRole::Spine),
    both("rib", PartRole::Rib),
    both("ribs", PartRole::Rib),
    both("costal cartilage", PartRole::Rib),
    both("sternum", PartRole::Rib),
    both("manubrium", PartRole::Rib),
    both("xiphoid", PartRole::Rib),
    both("clavicle", PartRole::Rib),
    both("scapula", PartRole::Rib),
    both("heart", PartRole::Heart),
    both("atrium", PartRole::Heart),
    both("wall of ventricle", PartRole::Heart),
    both("left ventricle", PartRole::Heart),
    both("right ventricle", PartRole::Heart),
    both("skin", PartRole::Skin),
    both("muscle", PartRole::Muscle),
    both("digastric", PartRole::Muscle),
    both("platysma", PartRole::Muscle),
    both("omohyoid", PartRole::Muscle),
    both("geniohyoid", PartRole::Muscle),
    both("mylohyoid", PartRole::Muscle),
    both("stylohyoid", PartRole::Muscle),
    both("sternohyoid", PartRole::Muscle),
    both("thyrohyoid", PartRole::Muscle),
    both("sternothyroid", PartRole::Muscle),
    both("sternocleidomastoid", PartRole::Muscle),
};

/// The name in lower case, its words apart by one space, with a space at each end.
std::string spacedWords(std::string_view name)
{
    std::string words{" "};
    char before = ' ';
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        const bool newWord = std::isupper(byte) != 0 && std::islower(before) != 0;
        before = static_cast<char>(byte & 0x7f);
        if (newWord)
            words += ' ';
        if (std::isalnum(byte) != 0)
            words += static_cast<char>(std::tolower(byte));
        else if (words.back() != ' ')
            words += ' ';
    }
    return words + ' ';
}

bool holds(const std::string& words, std::string_view phrase)
{
    return words.find(' ' + std::string{phrase} + ' ') != std::string::npos;
}

std::optional<Side> sideOf(const std::string& words)
{
    const bool right = holds(words, "right") || holds(words, "r");
    const bool left = holds(words, "left") || holds(words, "l");
    if (right == left)
        return std::nullopt;
    return right ? Side::Right : Side::Left;
}

PartRole roleFromConcept(std::string_view conceptId)
{
    constexpr std::string_view kPrefix = "FMA";
    int number = 0;
    if (!conceptId.starts_with(kPrefix))
        return PartRole::Other;
    conceptId.remove_prefix(kPrefix.size());
    const char* end = conceptId.data() + conceptId.size();
    if (const auto read = std::from_chars(conceptId.data(), end, number); read.ptr != end)
        return PartRole::Other;
    for (const ConceptRole& known : kConceptRoles)
        if (number >= known.first && number <= known.last)
            return known.role;
    return PartRole::Other;
}

} // namespace

PartRole recogniseRole(std::string_view conceptId, std::string_view name)
{
    if (const PartRole role = roleFromConcept(conceptId); role != PartRole::Other)
        return role;
    const std::string words = spacedWords(name);
    const auto known = std::find_if(kPhraseRoles.begin(), kPhraseRoles.end(),
                                    [&](const PhraseRole& p) { return holds(words, p.phrase); });
    if (known == kPhraseRoles.end())
        return PartRole::Other;
    const std::optional<Side> side = sideOf(words);
    if (known->role != known->left && !side)
        return PartRole::Other;
    return side == Side::Left ? known->left : known->role;
}

std::optional<Side> sideFromName(std::string_view name) { return sideOf(spacedWords(name)); }

} // namespace carina
