// SPDX-License-Identifier: MIT
#include "ImportSurvey.h"

#include "../../shapes/Validate.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

namespace Shapes::Box2D {
namespace {

// The lists of Box2D begin with what was made last.
template <class T>
std::vector<const T*> InOrderOfMaking(const T* pNewest) {
  std::vector<const T*> all;
  for (; pNewest != nullptr; pNewest = pNewest->GetNext())
    all.push_back(pNewest);
  std::reverse(all.begin(), all.end());
  return all;
}

std::string NameRanges(const std::vector<int>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1)
      ++last;
    text.append(text.empty() ? "" : ", ").append(std::to_string(numbers[i]));
    if (last > i) text.append(last > i + 1 ? " to " : ", ").append(std::to_string(numbers[last]));
    i = last + 1;
  }
  return text;
}

bool IsCentred(const b2Fixture& fixture, const b2Body& body) {
  const b2Vec2& p = static_cast<const b2CircleShape&>(*fixture.GetShape()).m_p;
  // The centre of mass of one circle is its centre, but for the rounding of a product and a quotient.
  return b2Distance(p, body.GetLocalCenter()) <= 4.0f * std::numeric_limits<float>::epsilon() * p.Length();
}

} // namespace

std::string NameBodies(const std::vector<int>& bodies) {
  return (bodies.size() == 1 ? "body " : "bodies ") + NameRanges(bodies);
}

std::string NameFixture(const CPart& part) {
  return "body " + std::to_string(part.m_nBody) + " fixture " + std::to_string(part.m_nFixture);
}

CSurvey::CSurvey(const b2World& world)
    : m_stdBodies(InOrderOfMaking(world.GetBodyList())),
      m_bHasFilter(world.GetContactManager().m_contactFilter != nullptr) {
  for (int body = 0; body < static_cast<int>(m_stdBodies.size()); ++body)
    TakeBody(body);
  TakeJoints(world);
  FindKinds();
  DropWhatNoBallMeets();
}

void CSurvey::TakeBody(int body) {
  const b2Body& b2body = *m_stdBodies[static_cast<std::size_t>(body)];
  const std::vector<const b2Fixture*> fixtures = InOrderOfMaking(b2body.GetFixtureList());
  if (!b2body.IsEnabled()) {
    if (!fixtures.empty())
      m_stdNotes.push_back("Body " + std::to_string(body) + " is left out: it is disabled.");
    return;
  }
  if (b2body.GetType() == b2_dynamicBody) {
    TakeBall(body, fixtures);
    return;
  }
  for (std::size_t i = 0; i < fixtures.size(); ++i)
    m_stdParts.push_back({fixtures[i], body, static_cast<int>(i), false});
}

void CSurvey::TakeBall(int body, const std::vector<const b2Fixture*>& fixtures) {
  const b2Body& b2body = *m_stdBodies[static_cast<std::size_t>(body)];
  const auto isSolid = [](const b2Fixture* p) { return !p->IsSensor(); };
  const auto solid = std::count_if(fixtures.begin(), fixtures.end(), isSolid);
  const auto it = std::find_if(fixtures.begin(), fixtures.end(), isSolid);

  std::string reason;
  if (solid != 1)
    reason = "it has " + std::to_string(solid) + " solid fixtures, a ball has one";
  else if ((*it)->GetType() != b2Shape::e_circle)
    reason = "its solid fixture is no circle";
  else if (!IsCentred(**it, b2body))
    reason = "its circle is not about its centre of mass";
  else if (!(b2body.GetMass() > 0.0f))
    reason = "it has no mass";
  if (!reason.empty()) {
    m_stdNotes.push_back("Body " + std::to_string(body) + " (dynamic) is left out: " + reason + ".");
    return;
  }
  m_stdParts.push_back({*it, body, static_cast<int>(it - fixtures.begin()), true});
  if (fixtures.size() > 1)
    m_stdNotes.push_back("Body " + std::to_string(body) + " becomes a ball without its sensors.");
}

void CSurvey::TakeJoints(const b2World& world) {
  std::map<const b2Joint*, std::vector<int>>
      ends; // a joint that is constant does not say which bodies it has
  for (std::size_t i = 0; i < m_stdBodies.size(); ++i)
    for (const b2JointEdge* p = m_stdBodies[i]->GetJointList(); p != nullptr; p = p->next)
      ends[p->joint].push_back(static_cast<int>(i));
  for (const b2Joint* pJoint : InOrderOfMaking(world.GetJointList())) {
    const std::vector<int>& bodies = ends[pJoint];
    m_stdJoints.push_back({pJoint, bodies});
    if (!pJoint->GetCollideConnected()) m_stdJoined.emplace(bodies.front(), bodies.back());
  }
}

void CSurvey::FindKinds() {
  std::map<std::tuple<bool, bool, float, float, float, uint16, uint16, int16>, std::size_t> kinds;
  for (std::size_t i = 0; i < m_stdParts.size(); ++i) {
    CPart& part = m_stdParts[i];
    const b2Fixture& f = *part.m_pFixture;
    // Before it is compared with others: no order has a place for NaN.
    const std::string name = NameFixture(part);
    RequireRange((name + ": restitution").c_str(), f.GetRestitution(), 0.0f, g_fMaxElasticity);
    RequireFinite((name + ": friction").c_str(), f.GetFriction());
    RequireFinite((name + ": restitution threshold").c_str(), f.GetRestitutionThreshold());
    const b2Body& body = GetBody(part);
    RequireFinite((name + ": gravity scale").c_str(), body.GetGravityScale());
    RequireFinite((name + ": linear damping").c_str(), body.GetLinearDamping());
    RequireFinite((name + ": angular damping").c_str(), body.GetAngularDamping());
    const b2Filter& filter = f.GetFilterData();
    const CKind kind{part.m_bIsBall,
                     f.IsSensor(),
                     f.GetRestitution(),
                     f.GetFriction(),
                     f.GetRestitutionThreshold(),
                     filter,
                     {}};
    const auto [it, isNew] =
        kinds.try_emplace({kind.m_bIsBall, kind.m_bIsSensor, kind.m_fRestitution, kind.m_fFriction,
                           kind.m_fThreshold, filter.categoryBits, filter.maskBits, filter.groupIndex},
                          m_stdKinds.size());
    if (isNew) m_stdKinds.push_back(kind);
    part.m_nKind = it->second;
    m_stdKinds[part.m_nKind].m_stdParts.push_back(i);
  }
}

// A shape that no ball meets would only cost time, and be met if it is its group that keeps balls from it.
void CSurvey::DropWhatNoBallMeets() {
  const auto isBall = [](const CKind& kind) { return kind.m_bIsBall; };
  if (std::none_of(m_stdKinds.begin(), m_stdKinds.end(), isBall)) return;
  std::set<std::size_t> dropped;
  for (std::size_t k = 0; k < m_stdKinds.size(); ++k) {
    if (m_stdKinds[k].m_bIsBall) continue;
    bool isMet = false;
    for (std::size_t ball = 0; ball < m_stdKinds.size(); ++ball)
      isMet |= m_stdKinds[ball].m_bIsBall && !AreFiltered(ball, k);
    if (isMet) continue;
    dropped.insert(k);
    m_stdNotes.push_back(
        "Left out, because the filters keep every ball from it: " + Name(m_stdKinds[k].m_stdParts) + ".");
  }
  if (dropped.empty()) return;
  std::erase_if(m_stdParts, [&](const CPart& part) { return dropped.contains(part.m_nKind); });
  m_stdKinds.clear();
  FindKinds();
}

bool CSurvey::AreFiltered(std::size_t kind0, std::size_t kind1) const {
  FailIf(!m_bHasFilter);
  const b2Filter &a = m_stdKinds[kind0].m_cFilter, &b = m_stdKinds[kind1].m_cFilter;
  if (a.groupIndex == b.groupIndex && a.groupIndex != 0) return a.groupIndex < 0;
  return (a.maskBits & b.categoryBits) == 0 || (a.categoryBits & b.maskBits) == 0;
}

CFilter CSurvey::GetFilter(std::size_t kind) const {
  const b2Filter& filter = m_stdKinds[kind].m_cFilter;
  return m_bHasFilter ? CFilter{filter.categoryBits, filter.maskBits} : CFilter();
}

bool CSurvey::AreJoined(int body0, int body1) const {
  return m_stdJoined.contains(std::minmax(body0, body1));
}

bool CSurvey::DoMeet(std::size_t kind0, std::size_t kind1) const {
  const CKind &a = m_stdKinds[kind0], &b = m_stdKinds[kind1];
  FailIf(!a.m_bIsBall && !b.m_bIsBall);
  FailIf(a.m_bIsSensor || b.m_bIsSensor || AreFiltered(kind0, kind1));
  for (const std::size_t i : a.m_stdParts)
    for (const std::size_t j : b.m_stdParts)
      if (i != j && !AreJoined(m_stdParts[i].m_nBody, m_stdParts[j].m_nBody)) return true;
  return false;
}

std::vector<CBouncePair> CSurvey::GetMeetingPairs() const {
  std::vector<CBouncePair> pairs;
  for (std::size_t i = 0; i < m_stdKinds.size(); ++i)
    for (std::size_t j = 0; j < m_stdKinds.size(); ++j)
      // Once, the ball first.
      if (m_stdKinds[i].m_bIsBall && (i <= j || !m_stdKinds[j].m_bIsBall) && DoMeet(i, j))
        pairs.push_back({i, j});
  return pairs;
}

std::string CSurvey::Name(const std::vector<std::size_t>& parts) const {
  std::map<int, std::vector<int>> fixtures;
  for (const std::size_t i : parts)
    fixtures[m_stdParts[i].m_nBody].push_back(m_stdParts[i].m_nFixture);
  std::vector<int> whole;
  std::string some;
  for (const auto& [body, numbers] : fixtures) {
    int count = 0;
    for (const b2Fixture* p = m_stdBodies[static_cast<std::size_t>(body)]->GetFixtureList(); p;
         p = p->GetNext())
      ++count;
    if (m_stdParts[parts.front()].m_bIsBall || count == static_cast<int>(numbers.size()))
      whole.push_back(body);
    else
      some.append(some.empty() ? "body " : ", body ")
          .append(std::to_string(body))
          .append(numbers.size() == 1 ? " fixture " : " fixtures ")
          .append(NameRanges(numbers));
  }
  if (whole.empty()) return some;
  return NameBodies(whole) + (some.empty() ? "" : ", " + some);
}

} // namespace Shapes::Box2D
